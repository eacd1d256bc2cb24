#pragma once

#include <array>

#include "module_file.hpp"

/// All modules. The package of a module is the one with the library that building the module needs.
/// Its name is the same in Debian 12, 13 and testing.
namespace lineatlas::module_files {

inline constexpr ModuleFile png{.name = "lineatlas-png",
                                .purpose = "which reads and writes pictures",
                                .library = "libpng",
                                .package = "libpng-dev"};
inline constexpr ModuleFile images{.name = "lineatlas-images",
                                   .purpose = "which reads and writes pictures",
                                   .library = "OpenImageIO",
                                   .package = "libopenimageio-dev",
                                   .own_package = "lineatlas-images"};
inline constexpr ModuleFile gltf{.name = "lineatlas-gltf",
                                 .purpose = "which reads glTF models",
                                 .library = "Draco or meshoptimizer",
                                 .package = "libdraco-dev libmeshoptimizer-dev"};
inline constexpr ModuleFile threemf{.name = "lineatlas-3mf",
                                    .purpose = "which reads 3MF models",
                                    .library = "lib3mf",
                                    .package = "lib3mf-dev libzip-dev"};
inline constexpr ModuleFile brep{.name = "lineatlas-brep",
                                 .purpose = "which reads STEP, IGES and BREP models",
                                 .library = "Open CASCADE",
                                 .package = "libocct-data-exchange-dev",
                                 .own_package = "lineatlas-brep"};
inline constexpr ModuleFile pdf{.name = "lineatlas-pdf",
                                .purpose = "which writes PDF",
                                .library = "cairo",
                                .package = "libcairo2-dev",
                                .own_package = "lineatlas-pdf"};
inline constexpr ModuleFile rays{.name = "lineatlas-rays",
                                 .purpose = "which checks drawings by rays",
                                 .library = "Embree",
                                 .package = "libembree-dev",
                                 .own_package = "lineatlas-rays"};

inline constexpr std::array all{&png, &images, &gltf, &threemf, &brep, &pdf, &rays};

} // namespace lineatlas::module_files
