#pragma once

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "lineatlas/renderer.hpp"
#include "output/frame_output.hpp"
#include "output_places.hpp"

namespace lineatlas::apps {

/// `--profile`: where profiles of frames go.
class ProfileOptions {
  public:
    void declare(CLI::App& app, const std::string& group);
    /// Throws UsageError for another extension, FileError for a file that can't be written.
    void check() const;
    bool given() const { return !paths_.empty(); }
    /// Adds its files. Throws UsageError for one that is taken.
    void add_to(OutputPlaces& places) const;
    void write(std::span<const FrameProfile> frames, const std::string& description) const;

  private:
    std::vector<std::string> paths_; ///< .json, .csv or -
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
