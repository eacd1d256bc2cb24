#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "lineatlas/renderer.hpp"
#include "setting.hpp"

namespace lineatlas {

/// A word for how exactly a frame is computed.
enum class Quality { low, high };

/// The options that a quality stands for in a picture of pixels.
struct Sampling {
    std::uint32_t probes; ///< FrameOptions::probes
    int depth_scale;      ///< FrameOptions::depth_scale
    bool operator==(const Sampling&) const = default;
};
constexpr Sampling sampling_of(Quality quality) {
    return quality == Quality::high ? Sampling{9, 2} : Sampling{1, 1};
}

inline constexpr std::array<std::uint32_t, 4> probe_counts{1, 4, 9, 16};

/// How frames are drawn, as people choose it. Choices that they leave open follow from the quality
/// and from the purpose of the frame.
struct FrameSettings {
    /// Nothing: exact, or atlas if something asks for samples and for pictures of a sequence.
    std::optional<Method> method{};
    Quality quality = Quality::high;
    std::optional<std::uint32_t> probes{}; ///< nothing: the quality's
    std::optional<int> depth_scale{};      ///< nothing: the quality's
    /// All other options. Its method, probes and depth_scale do not count.
    FrameOptions rest{};

    /// The options for a picture of pixels.
    FrameOptions for_pixels() const;
    /// The options for pictures of pixels that are shown one after the other.
    FrameOptions for_sequence() const;
    /// The options for intervals or paths of a picture of this size.
    FrameOptions for_paths(glm::ivec2 size) const;

  private:
    /// Whether an option is chosen that only samples have.
    bool asks_for_samples() const;
};

/// The depth scale for paths, whose ends are those of the depth buffer. If pixels have more than
/// one depth texel, paths get the finest scale that GL's limits allow for a picture of this size.
int depth_scale_of_paths(int depth_scale, glm::ivec2 size);

/// One member of FrameSettings.
using FrameSetting = SettingOf<FrameSettings>;

/// The one table of frame settings, in the order for readers. It lacks FrameOptions::steady, which
/// only programs choose that draw frames one after the other. Names of choices stand in the order
/// of their enumerators.
std::span<const FrameSetting> frame_settings();

/// The setting with this key. Throws UsageError that names the nearest key.
const FrameSetting& find_frame_setting(std::string_view key);

/// Throws UsageError for the first member with a value that its setting does not allow. Ignores the
/// style. Allocates nothing.
void check_frame_options(const FrameOptions& options);

/// The name of a method for `--method`.
const std::string& name_of(Method method);

/// All frame settings as the Markdown table of docs/output.md.
std::string frame_settings_table();

/// Kinds of line by name with commas between, as in "crease,silhouette"; nothing if there is no
/// such kind.
std::optional<LineKindMask> line_kinds_from(std::string_view text);
std::string line_kinds_to_text(LineKindMask kinds);

/// LineOptions::silhouettes, by silhouettes_names.
Silhouettes parse_silhouettes(std::string_view option, const std::string& text);

} // namespace lineatlas
