# The shared libraries, made of the rooms' objects, and all that is installed.
include(CMakePackageConfigHelpers)

# A change of the soname goes with one of the version in lineatlas.map.
set(lineatlas_soversion ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(lineatlas_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/lineatlas)

# lineatlas::NAME of the given rooms, as component COMPONENT of the package.
function(add_shared_library target)
    cmake_parse_arguments(arg "" "NAME;FILE;RUNTIME;DEVELOPMENT" "ROOMS;PUBLIC;PRIVATE" ${ARGN})
    list(TRANSFORM arg_ROOMS REPLACE "(.+)" "$<TARGET_OBJECTS:lineatlas_\\1>" OUTPUT_VARIABLE objects)
    if("compute" IN_LIST arg_ROOMS)
        get_property(kernels GLOBAL PROPERTY lineatlas_kernel_objects)
        list(APPEND objects ${kernels})
    endif()
    add_library(${target} SHARED ${objects})
    add_library(lineatlas::${arg_NAME} ALIAS ${target})
    target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE} ${CMAKE_DL_LIBS})
    target_compile_features(${target} INTERFACE cxx_std_20)
    set(map ${PROJECT_SOURCE_DIR}/cmake/lineatlas.map)
    target_link_options(${target} PRIVATE -Wl,--version-script=${map} -Wl,-z,defs -Wl,--as-needed)
    set_target_properties(${target} PROPERTIES
        OUTPUT_NAME ${arg_FILE} EXPORT_NAME ${arg_NAME} LINKER_LANGUAGE CXX LINK_DEPENDS ${map}
        VERSION ${PROJECT_VERSION} SOVERSION ${lineatlas_soversion}
        LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
    install(TARGETS ${target} EXPORT lineatlas-${arg_NAME}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
            COMPONENT ${arg_RUNTIME} NAMELINK_COMPONENT ${arg_DEVELOPMENT}
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    install(EXPORT lineatlas-${arg_NAME} NAMESPACE lineatlas:: FILE lineatlas-${arg_NAME}.cmake
        DESTINATION ${lineatlas_package_dir} COMPONENT ${arg_DEVELOPMENT})
endfunction()

add_shared_library(lineatlas_shared NAME lineatlas FILE lineatlas
    RUNTIME runtime DEVELOPMENT development
    ROOMS base surface core lines sources compute visibility gl interop renderer style vector sheets fills profile polygon section scenes
    PUBLIC glm::glm
    PRIVATE PkgConfig::epoxy fmt::fmt tomlplusplus::tomlplusplus TBB::tbb)
target_include_directories(lineatlas_shared INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/host/include>
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/kernels>)
add_shared_library(lineatlas_headless_shared NAME headless FILE lineatlas-headless
    RUNTIME runtime DEVELOPMENT development
    ROOMS headless PUBLIC lineatlas_shared PRIVATE PkgConfig::epoxy)
add_shared_library(lineatlas_io_shared NAME io FILE lineatlas-io
    RUNTIME io DEVELOPMENT io-development
    ROOMS base io polygon PUBLIC lineatlas_shared PRIVATE OpenMeshCore fmt::fmt TBB::tbb
                                         $<TARGET_NAME_IF_EXISTS:PkgConfig::seccomp>)

# Modules of the room io, which looks for them beside the shared library and beside the tool.
install(TARGETS lineatlas-png LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/lineatlas COMPONENT io)
if(TARGET lineatlas-gltf)
    install(TARGETS lineatlas-gltf LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/lineatlas COMPONENT io)
endif()
if(TARGET lineatlas-3mf)
    install(TARGETS lineatlas-3mf LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/lineatlas COMPONENT io)
endif()
# Modules with large dependencies (OpenImageIO, Open CASCADE), in components of their own.
if(TARGET lineatlas-images)
    install(TARGETS lineatlas-images
            LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/lineatlas COMPONENT images)
endif()
if(TARGET lineatlas-brep)
    install(TARGETS lineatlas-brep lineatlas-reader
            LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/lineatlas COMPONENT brep
            RUNTIME DESTINATION ${CMAKE_INSTALL_LIBDIR}/lineatlas COMPONENT brep)
endif()
# The module that checks drawings.
if(TARGET lineatlas-rays)
    install(TARGETS lineatlas-rays LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/lineatlas COMPONENT rays)
endif()

# The module that writes PDF.
if(TARGET lineatlas-pdf)
    install(TARGETS lineatlas-pdf LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/lineatlas COMPONENT pdf)
endif()

install(DIRECTORY host/include/lineatlas DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        COMPONENT development)
install(FILES kernels/flags.h kernels/segment_table.h kernels/style_numbers.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lineatlas
        COMPONENT development)

configure_package_config_file(cmake/lineatlas-config.cmake.in lineatlas-config.cmake
    INSTALL_DESTINATION ${lineatlas_package_dir})
# Before 1.0, every minor version may break what was.
write_basic_package_version_file(lineatlas-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/lineatlas-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/lineatlas-config-version.cmake
        DESTINATION ${lineatlas_package_dir} COMPONENT development)

file(RELATIVE_PATH prefix_from_pkgconfig
     ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
function(install_pkgconfig name component description)
    set(requires ${ARGN})
    configure_file(cmake/lineatlas.pc.in ${name}.pc @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc
            DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT ${component})
endfunction()
install_pkgconfig(lineatlas development "${PROJECT_DESCRIPTION}" glm)
install_pkgconfig(lineatlas-headless development "GL contexts for lineatlas without a window" lineatlas)
install_pkgconfig(lineatlas-io io-development "Files of models and pictures for lineatlas" lineatlas)

install(TARGETS lineatlas RUNTIME COMPONENT tool)
find_program(GZIP gzip REQUIRED)
set(manual ${CMAKE_CURRENT_BINARY_DIR}/lineatlas.1.gz)
execute_process(COMMAND ${GZIP} -9nc ${PROJECT_SOURCE_DIR}/packaging/lineatlas.1 OUTPUT_FILE ${manual}
                COMMAND_ERROR_IS_FATAL ANY)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS packaging/lineatlas.1)
install(FILES ${manual} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tool)

install(FILES packaging/lineatlas.bash RENAME lineatlas COMPONENT tool
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
# For LINEATLAS_KERNEL_DIR, to copy and edit.
install(DIRECTORY kernels DESTINATION ${CMAKE_INSTALL_DATADIR}/lineatlas COMPONENT tool)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
