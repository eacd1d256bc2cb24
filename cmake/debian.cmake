# Debian packages by CPack (./run package). The libraries are apart from the tool, and io from the
# rest, so that nobody installs OpenImageIO who has no use for it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The lineatlas developers")
set(CPACK_PACKAGE_CONTACT "The lineatlas developers <lineatlas@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(packaged_version ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
find_program(GZIP gzip)
set(changelog ${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian)
file(WRITE ${changelog} "lineatlas (${packaged_version}) unstable; urgency=medium

  * Built from the source of lineatlas ${PROJECT_VERSION}.

 -- ${CPACK_PACKAGE_CONTACT}  Sat, 21 Nov 2026 00:00:00 +0000
")
if(GZIP)
    execute_process(COMMAND ${GZIP} -9nkf ${changelog})
endif()

# PACKAGE is what COMPONENT is installed as.
function(describe_package component package section depends summary)
    string(TOUPPER ${component} upper)
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package} PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}
lineatlas finds the lines of a 3D model and draws what is visible of them.
Visibility is computed by OpenCL kernels that share buffers with OpenGL." PARENT_SCOPE)
    set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
    set(folder ${CMAKE_INSTALL_DATADIR}/doc/${package})
    install(FILES LICENSE RENAME copyright DESTINATION ${folder} COMPONENT ${component})
    if(GZIP)
        install(FILES ${changelog}.gz DESTINATION ${folder} COMPONENT ${component})
    endif()
endfunction()

set(base liblineatlas${lineatlas_soversion})
set(io liblineatlas-io${lineatlas_soversion})
set(same "(= ${packaged_version})")
describe_package(runtime ${base} libs "" "line drawings of 3D models - shared libraries")
describe_package(io ${io} libs "" "line drawings of 3D models - files of models and pictures")
describe_package(development liblineatlas-dev libdevel "${base} ${same}, libglm-dev"
                 "line drawings of 3D models - to develop with")
describe_package(io-development liblineatlas-io-dev libdevel
                 "${io} ${same}, liblineatlas-dev ${same}"
                 "line drawings of 3D models - to develop with files")
describe_package(tool lineatlas graphics "${io} ${same}" "line drawings of 3D models")

# Drivers of OpenGL and OpenCL are not linked.
set(drivers "libegl1, libgl1-mesa-dri | libgl1-nvidia-glvnd-glx, pocl-opencl-icd | opencl-icd")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "${drivers}")
set(CPACK_DEBIAN_TOOL_PACKAGE_RECOMMENDS "${drivers}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "liblineatlas-io-dev, libepoxy-dev, pkg-config")
include(CPack)
