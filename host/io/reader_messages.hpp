#pragma once

#include "lineatlas/io.hpp"
#include "reader_process.hpp"

namespace lineatlas {

// Results of reading, sent from the process that reads to the process that asked. receive_model()
// and receive_picture() throw FileError for results that is_sound() refuses.

void send(ReaderOutput& output, const LoadedMesh& loaded);
LoadedMesh receive_model(ReaderProcess& process);

void send(ReaderOutput& output, const Image& image);
Image receive_picture(ReaderProcess& process);

} // namespace lineatlas
