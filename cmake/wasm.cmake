# Compiles for WebAssembly with Debian's clang, libc++ and wasi-libc (CMAKE_TOOLCHAIN_FILE). `./run web` installs them.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(wasm_clang 22 CACHE STRING "version of clang, lld, llvm and libc++")
set(CMAKE_CXX_COMPILER clang++-${wasm_clang})
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
find_program(CMAKE_AR llvm-ar-${wasm_clang} REQUIRED)
find_program(CMAKE_RANLIB llvm-ranlib-${wasm_clang} REQUIRED)
# Exceptions as browsers have had them the longest; SIMD and what came before it.
set(CMAKE_CXX_FLAGS_INIT
    "-Wno-deprecated -msimd128 -mbulk-memory -mnontrapping-fptoint -mmutable-globals -msign-ext -fwasm-exceptions -mllvm -wasm-use-legacy-eh")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
