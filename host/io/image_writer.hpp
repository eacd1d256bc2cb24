#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "image_loader.hpp"
#include "lineatlas/io.hpp"
#include "reader_process.hpp"

namespace lineatlas {

/// Writes pictures from a process of its own, which loads the module for pictures while this one
/// draws, and encodes one picture while this one draws the next. A thread would not do: while
/// libraries load, the dynamic linker blocks every thread that looks up a function, as GL does all
/// the time.
///
/// Make it early: in a program that already has several threads, or if no process can be started,
/// pictures are written in this process, as write_image() does. SIGINT and SIGTERM do not reach the
/// other process, so that its pictures are whole however this one ends.
class ImageWriter {
  public:
    /// `first`: a name like that of the first picture; the module for its type loads at once.
    /// `limits`: those of encoding a picture; 0: by the picture's size.
    explicit ImageWriter(const std::filesystem::path& first = "picture.png",
                         const ReadLimits& limits = {});
    /// Waits for the last picture, and does not report its errors.
    ~ImageWriter();
    ImageWriter(const ImageWriter&) = delete;
    ImageWriter& operator=(const ImageWriter&) = delete;

    /// As write_image(), but may return before the file is there. Throws FileError, about this
    /// picture or the one before.
    void write(const std::filesystem::path& path, const Pixels& pixels,
               const ImageSettings& settings = {});
    /// As write(), for a picture whose values come in pieces: `pixels` has none, and append()
    /// follows until all are there. Nothing is written before that.
    void begin(const std::filesystem::path& path, const Pixels& pixels,
               const ImageSettings& settings = {});
    void append(std::span<const std::byte> values);
    /// Gives up the picture that begin() began and of which values are missing: nothing of it is
    /// written. The other process ends with it, and this one writes later pictures.
    void abandon();
    /// Waits for the last picture. Throws FileError.
    void finish();
    /// Whether `path` holds a whole picture of this size. Throws FileError, about the picture
    /// before.
    bool is_whole(const std::filesystem::path& path, glm::ivec2 size);

  private:
    void start(PictureType first, const ReadLimits& limits);
    void end();

    int process_ = -1; ///< -1: everything is done in this process
    int socket_ = -1;
    bool writing_ = false; ///< a picture is being written

    /// A picture that comes in pieces and is written in this process.
    struct Growing {
        std::filesystem::path path;
        Pixels pixels;
        ImageSettings settings;
        std::vector<std::byte> values;
    };
    std::optional<Growing> growing_;
};

} // namespace lineatlas
