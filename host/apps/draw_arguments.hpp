#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "command_line/device_options.hpp"
#include "command_line/part_filter.hpp"
#include "command_line/read_options.hpp"
#include "command_line/setting_options.hpp"
#include "command_line/style_options.hpp"
#include "command_line/view_options.hpp"
#include "explode_options.hpp"
#include "lineatlas/lines.hpp"
#include "path_options.hpp"
#include "picture_options.hpp"
#include "profile_output.hpp"
#include "section_options.hpp"
#include "sequence_options.hpp"
#include "sheet_arguments.hpp"
#include "style/frame_settings.hpp"

namespace lineatlas::apps {

/// The command line of `draw` as written; an empty member was not given.
struct DrawArguments {
    std::string model, scene, output;
    std::string session; ///< the session that MODEL names
    /// Models that are drawn: MODEL, or those of the session.
    std::vector<std::filesystem::path> models;
    std::string size = "1024x768";
    ViewOptions view;
    float at = 0;
    std::string crease = "auto";
    std::string silhouettes; ///< empty: chosen by whether the file has normals
    bool smooth_edges = false;
    double deflection = 0; ///< 0: not given
    SectionOptions sections;
    SettingOptions<FrameSettings> frame;
    StyleOptions style;
    ReadOptions read;
    PartFilter parts;
    ExplodeOptions explode;
    SequenceOptions sequence;
    PictureOptions picture;
    PathOptions paths;
    SheetArguments sheet;
    DeviceOptions device;
    bool stats = false;
    ProfileOptions profile;
    KernelOptions kernels;
    int repeat = 2; ///< measured frames; for --stats whole ones and frames by stages in turn

    bool profiled() const { return profile.given() || kernels.given(); }
};

/// The values of the command line. These throw UsageError.
Silhouettes silhouettes(const DrawArguments& arguments);
std::optional<float> crease_angle(const DrawArguments& arguments);

} // namespace lineatlas::apps
