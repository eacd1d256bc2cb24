#pragma once

#include <filesystem>

#include "lineatlas/io.hpp"

namespace lineatlas {

/// Writes one picture from a process of its own, which loads the module for pictures while this one
/// draws. A thread would not do: the dynamic linker holds up everyone who looks up a function, as
/// GL does all the time, until the last library is loaded.
///
/// To be made early: in a program that has several threads already, or where no process can be
/// started, the picture is written here, as write_image() does.
class ImageWriter {
  public:
    /// Checks the path as check_image_path() does. Throws FileError.
    explicit ImageWriter(const std::filesystem::path& path);
    /// Ends the process if nothing was written.
    ~ImageWriter();
    ImageWriter(const ImageWriter&) = delete;
    ImageWriter& operator=(const ImageWriter&) = delete;

    /// As write_image(). Call once. Throws FileError.
    void write(const Image& image);

  private:
    void start();
    void end();

    std::filesystem::path path_;
    int process_ = -1;
    int socket_ = -1;
};

} // namespace lineatlas
