# Modules: loaded when they are needed, and looked for in lib/lineatlas.
file(RELATIVE_PATH libraries_from_programs
     ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
function(add_module name)
    cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES" ${ARGN})
    add_library(lineatlas-${name} MODULE ${arg_SOURCES})
    target_link_libraries(lineatlas-${name} PRIVATE ${arg_LIBRARIES})
    target_compile_definitions(lineatlas-${name} PRIVATE LINEATLAS_VERSION="${PROJECT_VERSION}")
    set_target_properties(lineatlas-${name} PROPERTIES
        PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib/lineatlas)
    set_property(GLOBAL APPEND_STRING PROPERTY lineatlas_modules "lineatlas-${name} ")
endfunction()

# Pictures.
add_room(pixels host/images/pixels.cpp)
add_module(png SOURCES host/images/png/images.cpp LIBRARIES PNG::PNG lineatlas_pixels)
add_dependencies(lineatlas_io lineatlas-png)
# Debian ships the CMake files of OpenImageIO without all that they refer to.
pkg_check_modules(openimageio QUIET IMPORTED_TARGET OpenImageIO)
find_part(OPENIMAGEIO "pictures of all types" NEEDS openimageio_FOUND OpenImageIO libopenimageio-dev)
if(HAS_OPENIMAGEIO)
    add_module(images SOURCES host/images/openimageio/images.cpp LIBRARIES PkgConfig::openimageio lineatlas_pixels)
    add_dependencies(lineatlas_io lineatlas-images)
endif()

# A module for each family of model formats that needs a library.
function(add_model_module name)
    file(GLOB sources CONFIGURE_DEPENDS host/models/${name}/*.cpp)
    add_module(${name} SOURCES ${sources} LIBRARIES lineatlas_options glm::glm ${ARGN})
    precompile_common_headers(lineatlas-${name})
    add_dependencies(lineatlas_io lineatlas-${name})
endfunction()
find_package(draco QUIET)
find_package(meshoptimizer QUIET)
find_part(GLTF "glTF models" NEEDS draco_FOUND Draco libdraco-dev
                                   meshoptimizer_FOUND meshoptimizer libmeshoptimizer-dev)
if(HAS_GLTF)
    add_model_module(gltf draco::draco meshoptimizer::meshoptimizer nlohmann_json::nlohmann_json)
    target_precompile_headers(lineatlas-gltf PRIVATE <nlohmann/json.hpp>)
endif()
pkg_check_modules(lib3mf QUIET IMPORTED_TARGET lib3MF)
pkg_check_modules(libzip QUIET IMPORTED_TARGET libzip)
find_part(3MF "3MF models" NEEDS lib3mf_FOUND lib3mf lib3mf-dev libzip_FOUND libzip libzip-dev)
if(HAS_3MF)
    add_model_module(3mf PkgConfig::lib3mf PkgConfig::libzip)
    optimise_lightly(lineatlas-3mf)
endif()
# The headers of Open CASCADE are for older standards, and its CMake files ask for all of it. Since 7.8
# two libraries have what four had before.
find_path(opencascade_includes STEPCAFControl_Reader.hxx PATH_SUFFIXES opencascade)
find_library(opencascade_step NAMES TKDESTEP TKXDESTEP)
find_part(BREP "STEP, IGES and BREP models"
          NEEDS opencascade_includes "headers of Open CASCADE" libocct-data-exchange-dev
                opencascade_step "library TKDESTEP or TKXDESTEP of Open CASCADE" libocct-data-exchange-dev)
if(HAS_BREP)
    set(opencascade_exchange TKDESTEP TKDEIGES)
    if(opencascade_step MATCHES TKXDESTEP)
        set(opencascade_exchange TKXDESTEP TKXDEIGES TKSTEP TKIGES)
    endif()
    add_model_module(brep ${opencascade_exchange} TKXSBase TKXCAF TKMesh TKLCAF TKCAF TKShHealing
                          TKTopAlgo TKBRep TKGeomBase TKG3d TKG2d TKMath TKernel)
    target_include_directories(lineatlas-brep SYSTEM PRIVATE ${opencascade_includes})
    optimise_lightly(lineatlas-brep)
    # The process that reads for programs that embed the library, and may crash.
    add_executable(lineatlas-reader host/reader/main.cpp ${sanitizer_sources})
    target_link_libraries(lineatlas-reader PRIVATE lineatlas_io)
    set_target_properties(lineatlas-reader PROPERTIES
        RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib/lineatlas)
endif()

# The module that checks drawings. Embree 3 and 4 have different interfaces.
foreach(version 4 3)
    if(NOT embree_FOUND)
        find_package(embree ${version} CONFIG QUIET)
        set(embree_version ${version})
    endif()
endforeach()
find_part(RAYS "drawings checked by rays" NEEDS embree_FOUND "Embree 3 or 4" libembree-dev)
if(HAS_RAYS)
    add_module(rays SOURCES host/rays/embree.cpp LIBRARIES lineatlas_options glm::glm embree)
    target_compile_definitions(lineatlas-rays PRIVATE LINEATLAS_EMBREE=${embree_version})
endif()

pkg_check_modules(cairo QUIET IMPORTED_TARGET cairo-pdf)
find_part(PDF "drawings as PDF" NEEDS cairo_FOUND cairo libcairo2-dev)
if(HAS_PDF)
    add_module(pdf SOURCES host/cairo/cairo.cpp
               LIBRARIES lineatlas_options glm::glm PkgConfig::cairo)
endif()

# Lets messages tell a module that was left out from one that is not installed.
get_property(modules GLOBAL PROPERTY lineatlas_modules)
set_source_files_properties(host/io/module_file.cpp PROPERTIES COMPILE_DEFINITIONS
    "LINEATLAS_LIBRARIES_FROM_PROGRAMS=\"${libraries_from_programs}\";LINEATLAS_MODULES=\"${modules}\"")
