#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "command_line/cli_fwd.hpp"
#include "lineatlas/kernel_profile.hpp"
#include "lineatlas/renderer.hpp"
#include "output/frame_output.hpp"
#include "output_places.hpp"

namespace lineatlas::apps {

/// An option whose value is a file with one of some extensions, or "-" for the terminal. It may be
/// given several times.
class ReportOption {
  public:
    /// `extensions`: with their dots.
    ReportOption(std::string name, std::vector<std::string> extensions)
        : name_(std::move(name)), extensions_(std::move(extensions)) {}

    void declare(CLI::App& app, const std::string& help, const std::string& group);
    /// Throws UsageError for another extension. Throws FileError for a file that cannot be written.
    void check() const;
    bool given() const { return !paths_.empty(); }
    /// Adds its files to the places. Throws UsageError if a place is taken.
    void add_to(OutputPlaces& places) const;
    /// Writes the reports. `report` makes the text for an extension, which is empty for the
    /// terminal.
    void write(const std::function<std::string(std::string_view extension)>& report) const;

  private:
    std::string name_;
    std::vector<std::string> extensions_;
    std::vector<std::string> paths_;
};

/// `--profile`: where profiles of frames go.
class ProfileOptions : public ReportOption {
  public:
    ProfileOptions() : ReportOption("--profile", {".json", ".csv"}) {}
    void declare(CLI::App& app, const std::string& group);
    /// `kernels`: figures for the trace, of --kernels.
    void write(std::span<const FrameProfile> frames, const std::string& description,
               std::span<const KernelTime> kernels) const;
};

/// What --kernels reports.
struct KernelReport {
    std::vector<KernelTime> kernels{};
    Roofs roofs{};
    std::vector<std::string> notes{}; ///< what is missing, and why, a line each
};

/// `--kernels`: where to write why each kernel takes its time.
class KernelOptions : public ReportOption {
  public:
    KernelOptions() : ReportOption("--kernels", {".json", ".csv", ".svg"}) {}
    void declare(CLI::App& app, const std::string& group);
    /// Counts the work of kernels, and a CPU's events, while `draw` draws such a frame in the forms
    /// that it gets: those of `frames`, where `forms` leaves them open. The renderer stays on the
    /// counting device.
    static KernelReport measure(std::span<const FrameProfile> frames, const StageForms& forms,
                                Renderer& renderer,
                                const std::function<void(const StageForms&)>& draw);
    void write(const KernelReport& report) const;
};

/// Takes the profile of each frame that `output` has drawn.
class ProfiledOutput final : public FrameOutput {
  public:
    ProfiledOutput(FrameOutput& output, Renderer& renderer)
        : output_(output), renderer_(renderer) {}

    bool draw(const Camera& camera, const std::filesystem::path& path) override;
    void finish() override { output_.finish(); }
    bool is_whole(const std::filesystem::path& path, glm::ivec2 size) override {
        return output_.is_whole(path, size);
    }
    /// All profiles so far.
    std::vector<FrameProfile> take();

  private:
    void take(bool wait);

    FrameOutput& output_;
    Renderer& renderer_;
    std::vector<FrameProfile> frames_;
};

} // namespace lineatlas::apps
