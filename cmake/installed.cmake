# Manual pages that are made of what --help says, and the list of all that is installed.
if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python 3.9 COMPONENTS Interpreter QUIET)
set(manual_pages)
# NAME.1 of the component, as the program, and what follows it, describes itself.
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
    foreach(command draw check info styles devices scene bench)
        add_manual_page(lineatlas-${command} tool lineatlas ${command})
    endforeach()
else()
    message(STATUS "No manual pages of commands: they are made by python3")
endif()
add_custom_target(manuals ALL DEPENDS ${manual_pages})

# All that is installed; tests and benchmarks need not be there.
add_custom_target(installed DEPENDS lineatlas_shared lineatlas_headless_shared lineatlas_io_shared
                                    lineatlas-images lineatlas manuals
                                    $<TARGET_NAME_IF_EXISTS:lineatlas_python>
                                    $<TARGET_NAME_IF_EXISTS:lineatlas-gltf>
                                    $<TARGET_NAME_IF_EXISTS:lineatlas-3mf>
                                    $<TARGET_NAME_IF_EXISTS:lineatlas-brep>
                                    $<TARGET_NAME_IF_EXISTS:lineatlas-reader>
                                    $<TARGET_NAME_IF_EXISTS:lineatlas-rays>
                                    $<TARGET_NAME_IF_EXISTS:lineatlas-pdf>)
