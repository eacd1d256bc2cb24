# Writes OUTPUT, a C++ file that defines lineatlas::TABLE: the name and text of every file in FILES, which
# lie in folders named kernels, shaders or styles.
# Run as: cmake -DOUTPUT=... -DTABLE=... "-DFILES=a;b" -P embed_sources.cmake
set(text "#include \"sources/sources.hpp\"\n\nnamespace lineatlas {\n\n")
string(APPEND text "const std::vector<EmbeddedSource>& ${TABLE}() {\n")
string(APPEND text "    static const std::vector<EmbeddedSource> sources{\n")
foreach(file IN LISTS FILES)
    string(REGEX REPLACE ".*/(kernels|shaders|styles)/" "" name "${file}")
    file(READ "${file}" content)
    string(APPEND text "{\"${name}\", R\"lineatlas(${content})lineatlas\"},\n")
endforeach()
string(APPEND text "    };\n    return sources;\n}\n\n} // namespace lineatlas\n")
file(WRITE "${OUTPUT}" "${text}")
