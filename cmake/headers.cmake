# Libraries of which a lean build needs the headers alone, in a folder that has no others: those of the system itself are
# not for the compiler of another one.
set(lean_headers ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${lean_headers})
function(find_headers target folder package)
    find_path(${folder}_headers ${folder} NO_CACHE NO_CMAKE_FIND_ROOT_PATH NO_DEFAULT_PATH PATHS /usr/include)
    if(NOT ${folder}_headers)
        message(FATAL_ERROR "There are no headers of ${folder} (on Debian: apt install ${package})")
    endif()
    file(CREATE_LINK ${${folder}_headers}/${folder} ${lean_headers}/${folder} SYMBOLIC)
    add_library(${target} INTERFACE IMPORTED)
    target_include_directories(${target} SYSTEM INTERFACE ${lean_headers})
endfunction()
find_headers(glm::glm glm libglm-dev)
find_headers(fmt::fmt fmt libfmt-dev)
# Without the locales of C++, which are larger than all else.
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY FMT_STATIC_THOUSANDS_SEPARATOR=',')
find_headers(nlohmann_json::nlohmann_json nlohmann nlohmann-json3-dev)
