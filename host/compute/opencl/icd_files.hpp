#pragma once

#include <string>
#include <vector>

namespace lineatlas::compute {

/// A driver as the loader of OpenCL finds it: a file *.icd that names its library.
struct IcdFile {
    std::string path;
    std::string library;
    std::string cause{}; ///< why the library cannot be loaded; empty if it can be
};

/// All files that the loader reads: those of the folder or the file in OPENCL_VENDOR_PATH or
/// OCL_ICD_VENDORS, else of /etc/OpenCL/vendors. Loads each library as the loader does, so call it
/// after the loader. Empty without a loader.
std::vector<IcdFile> icd_files();

} // namespace lineatlas::compute
