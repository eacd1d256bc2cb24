// Messages about missing modules.
#include <string>

#include <gtest/gtest.h>

#include "io/module_files.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::test {
namespace {

TEST(ModuleFile, AModuleThatWasNotBuiltNamesTheLibraryToBuildIt) {
    constexpr ModuleFile module{.name = "lineatlas-nothing",
                                .purpose = "which reads nothing",
                                .library = "libnothing",
                                .package = "libnothing-dev",
                                .own_package = "lineatlas-nothing"};
    EXPECT_FALSE(was_built(module));
    EXPECT_TRUE(was_built(module_files::png));
    try {
        find_module(module);
        ADD_FAILURE() << "found";
    } catch (const FileError& error) {
        const std::string said = error.what();
        EXPECT_TRUE(
            said.ends_with("lineatlas-nothing.so\", which reads nothing: this lineatlas was built "
                           "without it; build "
                           "it anew with libnothing (on Debian: apt install libnothing-dev)"))
            << said;
    }
}

} // namespace
} // namespace lineatlas::test
