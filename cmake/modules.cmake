# Models of other kinds, each family by a module of its own, where its libraries are.
function(add_model_module name)
    file(GLOB sources CONFIGURE_DEPENDS host/models/${name}/*.cpp)
    add_module(${name} SOURCES ${sources} LIBRARIES lineatlas_options glm::glm ${ARGN})
    add_dependencies(lineatlas_io lineatlas-${name})
endfunction()
find_package(draco QUIET)
find_package(meshoptimizer QUIET)
if(draco_FOUND AND meshoptimizer_FOUND)
    add_model_module(gltf draco::draco meshoptimizer::meshoptimizer nlohmann_json::nlohmann_json)
else()
    message(STATUS "The module for glTF is left out: it needs libdraco-dev and libmeshoptimizer-dev")
endif()
pkg_check_modules(lib3mf QUIET IMPORTED_TARGET lib3MF)
pkg_check_modules(libzip QUIET IMPORTED_TARGET libzip)
if(lib3mf_FOUND AND libzip_FOUND)
    add_model_module(3mf PkgConfig::lib3mf PkgConfig::libzip)
else()
    message(STATUS "The module for 3MF is left out: it needs lib3mf-dev and libzip-dev")
endif()
# The headers of Open CASCADE are for older standards, and its CMake files ask for all of it.
find_path(opencascade_includes STEPCAFControl_Reader.hxx PATH_SUFFIXES opencascade)
find_library(opencascade_step TKXDESTEP)
if(opencascade_includes AND opencascade_step)
    add_model_module(brep TKXDESTEP TKXDEIGES TKXCAF TKMesh TKSTEP TKIGES TKXSBase TKLCAF TKCAF TKShHealing TKTopAlgo TKBRep
                          TKGeomBase TKG3d TKG2d TKMath TKernel)
    target_include_directories(lineatlas-brep SYSTEM PRIVATE ${opencascade_includes})
    # What reads with it for programs that embed the library, in a process that may crash.
    add_executable(lineatlas-reader host/reader/main.cpp ${sanitizer_sources})
    target_link_libraries(lineatlas-reader PRIVATE lineatlas_io)
    set_target_properties(lineatlas-reader PROPERTIES
        RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib/lineatlas)
else()
    message(STATUS "The module for STEP is left out: it needs libocct-data-exchange-dev")
endif()

# What checks drawings is built where Embree 3 is, as Debian 12 has it.
find_package(embree 3 QUIET)
if(embree_FOUND)
    add_module(rays SOURCES host/rays/embree.cpp LIBRARIES lineatlas_options glm::glm embree)
else()
    message(STATUS "The module that checks drawings is left out: it needs libembree-dev 3")
endif()

# PDF is written where cairo is.
pkg_check_modules(cairo QUIET IMPORTED_TARGET cairo-pdf)
if(cairo_FOUND)
    add_module(pdf SOURCES host/pdf/module/cairo.cpp
               LIBRARIES lineatlas_options glm::glm PkgConfig::cairo)
    target_compile_definitions(lineatlas-pdf PRIVATE LINEATLAS_VERSION="${PROJECT_VERSION}")
else()
    message(STATUS "The module that writes PDF is left out: it needs libcairo2-dev")
endif()
