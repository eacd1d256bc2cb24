# Debian packages by CPack (./run package). The libraries are apart from the tool, and io from the rest. Large dependencies are
# optional: OpenImageIO comes with the package images, Embree with rays, Open CASCADE with brep, cairo with pdf.
set(LINEATLAS_MAINTAINER "The lineatlas developers <maintainers@lineatlas.invalid>"
    CACHE STRING "Who answers for the packages")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_PACKAGE_VENDOR "The lineatlas developers")
set(CPACK_PACKAGE_CONTACT "${LINEATLAS_MAINTAINER}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Libraries of the other packages are here: dpkg 1.22 looks for everything that a package links.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR}/lib)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(packaged_version ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
set(changelog ${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian)
file(WRITE ${changelog} "lineatlas (${packaged_version}) unstable; urgency=medium

  * Built from the source of lineatlas ${PROJECT_VERSION}.

 -- ${CPACK_PACKAGE_CONTACT}  Sat, 21 Nov 2026 00:00:00 +0000
")
execute_process(COMMAND ${GZIP} -9nkf ${changelog} COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/triggers "activate-noawait ldconfig\n")

# Describes the Debian package PACKAGE, which installs COMPONENT.
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
    install(FILES ${changelog}.gz DESTINATION ${folder} COMPONENT ${component})
endfunction()

# Neither drivers nor their loaders are linked. Pictures need those of OpenGL; paths need none.
set(drivers "libegl1, libopengl0 | libgl1, libgl1-mesa-dri | libgl1-nvidia-glvnd-glx, ocl-icd-libopencl1 | libopencl1, pocl-opencl-icd | opencl-icd")
set(base liblineatlas${lineatlas_soversion})
set(io liblineatlas-io${lineatlas_soversion})
set(same "(= ${packaged_version})")
describe_package(runtime ${base} libs "" "line drawings of 3D models - shared libraries")
describe_package(io ${io} libs "${base} ${same}" "line drawings of 3D models - files of models and pictures")
describe_package(development liblineatlas-dev libdevel "${base} ${same}, libglm-dev"
                 "line drawings of 3D models - to develop with")
describe_package(io-development liblineatlas-io-dev libdevel
                 "${io} ${same}, liblineatlas-dev ${same}"
                 "line drawings of 3D models - to develop with files")
describe_package(tool lineatlas graphics "${io} ${same}" "line drawings of 3D models")
describe_package(documents lineatlas-doc doc "" "line drawings of 3D models - documents and examples")
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_ARCHITECTURE all)
list(APPEND tool_suggests lineatlas-doc)
if(TARGET lineatlas-view)
    describe_package(viewer lineatlas-viewer graphics "lineatlas ${same}"
                     "line drawings of 3D models - viewer")
    set(CPACK_DEBIAN_VIEWER_PACKAGE_RECOMMENDS "${drivers}")
    set(tool_recommends ", lineatlas-viewer")
endif()
if(bench_programs)
    describe_package(bench lineatlas-bench graphics "lineatlas ${same}"
                     "line drawings of 3D models - benchmarks")
    list(APPEND tool_suggests lineatlas-bench)
endif()

if(TARGET lineatlas-images)
    describe_package(images lineatlas-images graphics "" "line drawings of 3D models - pictures of many types")
    list(APPEND tool_suggests lineatlas-images)
endif()
if(TARGET lineatlas-rays)
    describe_package(rays lineatlas-rays graphics "" "line drawings of 3D models - checked by rays")
    list(APPEND tool_suggests lineatlas-rays)
endif()
if(TARGET lineatlas-brep)
    describe_package(brep lineatlas-brep graphics "" "line drawings of 3D models - STEP, IGES and BREP files")
    list(APPEND tool_suggests lineatlas-brep)
endif()
if(TARGET lineatlas-pdf)
    describe_package(pdf lineatlas-pdf graphics "" "line drawings of 3D models - written as PDF")
    list(APPEND tool_suggests lineatlas-pdf)
endif()
if(TARGET lineatlas_python)
    # The module is compiled for one version of Python; Debian has one.
    math(EXPR next_python "${Python_VERSION_MINOR} + 1")
    describe_package(python python3-lineatlas python
        "python3 (>= 3.${Python_VERSION_MINOR}~), python3 (<< 3.${next_python}), python3-numpy, ${io} ${same}"
        "line drawings of 3D models - Python package")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "${drivers}")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "lineatlas-images, lineatlas-brep, lineatlas-pdf")
    describe_package(blender lineatlas-blender graphics "blender (>= 3.3), python3-lineatlas (>= ${packaged_version})"
        "line drawings of 3D models - add-on for Blender")
    set(CPACK_DEBIAN_BLENDER_PACKAGE_ARCHITECTURE all)
    list(APPEND tool_suggests python3-lineatlas)
    foreach(component PYTHON BLENDER)
        set(CPACK_DEBIAN_${component}_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/prerm)
    endforeach()
endif()
list(APPEND tool_suggests binutils) # lineatlas kernels --assembly
list(JOIN tool_suggests ", " CPACK_DEBIAN_TOOL_PACKAGE_SUGGESTS)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "${drivers}")
set(CPACK_DEBIAN_TOOL_PACKAGE_RECOMMENDS "${drivers}${tool_recommends}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "lineatlas-doc, liblineatlas-io-dev, libepoxy-dev, pkg-config")
foreach(component RUNTIME IO)
    set(CPACK_DEBIAN_${component}_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_BINARY_DIR}/triggers)
endforeach()
include(CPack)
