# The viewer, in a window that nobody sees.
function(add_viewer_test name)
    cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES" ${ARGN})
    add_executable(${name} ${arg_SOURCES} ${sanitizer_sources})
    target_link_libraries(${name} PRIVATE lineatlas_viewer_window GTest::gtest_main ${arg_LIBRARIES})
    target_compile_definitions(${name} PRIVATE LINEATLAS_TOOL="$<TARGET_FILE:lineatlas>"
                                               LINEATLAS_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
    add_dependencies(${name} lineatlas lineatlas-view)
    add_test(NAME ${name} COMMAND ${XVFB_RUN} -a -s "-screen 0 1600x1200x24 -noreset" $<TARGET_FILE:${name}>)
    set_tests_properties(${name} PROPERTIES TIMEOUT ${test_timeout})
endfunction()

add_viewer_test(viewer_test SOURCES viewer_test.cpp)
add_viewer_test(viewer_window_test SOURCES viewer_window_test.cpp)
add_test_program(viewer_navigation_test SOURCES viewer_navigation_test.cpp LIBRARIES lineatlas_viewer)

# What OpenCL objects the viewer leaves behind, a layer below it counts.
add_viewer_test(viewer_soak_test SOURCES viewer_soak_test.cpp LIBRARIES ${CMAKE_DL_LIBS})
target_compile_definitions(viewer_soak_test PRIVATE
    LINEATLAS_FAULT_LAYER="$<TARGET_FILE:fault_layer>")
add_dependencies(viewer_soak_test fault_layer)
