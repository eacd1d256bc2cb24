#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "lineatlas/kernel_profile.hpp"
#include "lineatlas/renderer.hpp"
#include "output/frame_output.hpp"
#include "output_places.hpp"

namespace lineatlas::apps {

/// An option whose value is a file of some extension or, as "-", the terminal. It may be given
/// several times.
class ReportOption {
  public:
    /// `extensions`: with their dots.
    ReportOption(std::string name, std::vector<std::string> extensions)
        : name_(std::move(name)), extensions_(std::move(extensions)) {}

    void declare(CLI::App& app, const std::string& help, const std::string& group);
    /// Throws UsageError for another extension, FileError for a file that can't be written.
    void check() const;
    bool given() const { return !paths_.empty(); }
    /// Adds its files. Throws UsageError for one that is taken.
    void add_to(OutputPlaces& places) const;
    /// Writes what `report` makes for an extension; for the terminal that is empty.
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
    void write(std::span<const FrameProfile> frames, const std::string& description) const;
};

/// `--kernels`: where it goes why each kernel takes its time.
class KernelOptions : public ReportOption {
  public:
    KernelOptions() : ReportOption("--kernels", {".json", ".csv", ".svg"}) {}
    void declare(CLI::App& app, const std::string& group);
    /// Counts what kernels do while `draw` draws such a frame; the renderer stays on the device
    /// that counts.
    void write(std::span<const FrameProfile> frames, Renderer& renderer,
               const std::function<void()>& draw) const;
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
    /// All of them.
    std::vector<FrameProfile> take();

  private:
    void take(bool wait);

    FrameOutput& output_;
    Renderer& renderer_;
    std::vector<FrameProfile> frames_;
};

} // namespace lineatlas::apps
