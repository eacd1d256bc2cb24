# Manual pages that are made of what --help says, and the list of all that is installed.
set(bench_programs)
foreach(name frames kernels interop quality tune compare)
    if(TARGET lineatlas-bench-${name})
        list(APPEND bench_programs lineatlas-bench-${name})
    endif()
endforeach()

# Benchmarks and viewer are packages of their own. The tool needs neither; it runs those that it finds beside it.
if(bench_programs)
    install(TARGETS ${bench_programs} RUNTIME COMPONENT bench)
endif()
if(TARGET lineatlas-view)
    install(TARGETS lineatlas-view RUNTIME COMPONENT viewer)
    install(FILES packaging/lineatlas.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT viewer)
    install(FILES packaging/lineatlas.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT viewer)
    install(FILES packaging/lineatlas.svg COMPONENT viewer
            DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()

set(manual_pages)
# Makes the manual page NAME.1 of what the program, run with the arguments that follow it, says in --help.
function(add_manual_page name component program)
    set(page ${CMAKE_BINARY_DIR}/man/${name}.1.gz)
    add_custom_command(OUTPUT ${page}
        COMMAND ${Python_EXECUTABLE} ${PROJECT_SOURCE_DIR}/packaging/manual.py ${PROJECT_VERSION} ${page}
                $<TARGET_FILE:${program}> ${ARGN}
        DEPENDS ${program} packaging/manual.py VERBATIM)
    install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component})
    set(manual_pages ${manual_pages} ${page} PARENT_SCOPE)
endfunction()
if(Python_Interpreter_FOUND)
    file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/man)
    foreach(command draw check info styles devices kernels scene)
        add_manual_page(lineatlas-${command} tool lineatlas ${command})
    endforeach()
    if(TARGET lineatlas-view)
        add_manual_page(lineatlas-view viewer lineatlas-view)
    endif()
    if(HAS_BENCH)
        add_manual_page(lineatlas-bench bench lineatlas bench)
    endif()
    foreach(program ${bench_programs})
        add_manual_page(${program} bench ${program})
    endforeach()
else()
    message(STATUS "No manual pages of commands: they are made by python3")
endif()
add_custom_target(manuals ALL DEPENDS ${manual_pages})

# README and docs with all that they link to. Without Python they are installed with the links of the checkout.
set(documents ${CMAKE_BINARY_DIR}/documents)
if(Python_Interpreter_FOUND)
    file(RELATIVE_PATH headers_from_documents ${CMAKE_INSTALL_FULL_DOCDIR} ${CMAKE_INSTALL_FULL_INCLUDEDIR}/lineatlas)
    file(GLOB_RECURSE document_files CONFIGURE_DEPENDS docs/* styles/* examples/* farm/*)
    add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/documents.stamp
        COMMAND ${Python_EXECUTABLE} ${PROJECT_SOURCE_DIR}/packaging/documents.py ${PROJECT_SOURCE_DIR} ${documents}
                ${headers_from_documents}
        COMMAND ${CMAKE_COMMAND} -E touch ${CMAKE_BINARY_DIR}/documents.stamp
        DEPENDS packaging/documents.py README.md CHANGELOG.md SECURITY.md ${document_files} VERBATIM)
    add_custom_target(documents ALL DEPENDS ${CMAKE_BINARY_DIR}/documents.stamp)
    install(DIRECTORY ${documents}/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents)
else()
    install(FILES README.md CHANGELOG.md SECURITY.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents)
    install(DIRECTORY docs styles examples farm DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents)
endif()

# Everything that is installed, without the tests.
add_custom_target(installed DEPENDS lineatlas_shared lineatlas_headless_shared lineatlas_io_shared
                                    lineatlas-png lineatlas manuals $<TARGET_NAME_IF_EXISTS:documents>
                                    ${bench_programs} $<TARGET_NAME_IF_EXISTS:lineatlas-view>
                                    $<TARGET_NAME_IF_EXISTS:lineatlas_python>
                                    $<TARGET_NAME_IF_EXISTS:lineatlas-images>
                                    $<TARGET_NAME_IF_EXISTS:lineatlas-gltf>
                                    $<TARGET_NAME_IF_EXISTS:lineatlas-3mf>
                                    $<TARGET_NAME_IF_EXISTS:lineatlas-brep>
                                    $<TARGET_NAME_IF_EXISTS:lineatlas-reader>
                                    $<TARGET_NAME_IF_EXISTS:lineatlas-rays>
                                    $<TARGET_NAME_IF_EXISTS:lineatlas-pdf>)
