// The table of tuning values: which row a device gets, and what a wrong table says.

#include <fstream>

#include <gtest/gtest.h>

#include "compute/opencl/quirks.hpp"
#include "compute/opencl/tuning_table.hpp"
#include "environment_variable.hpp"
#include "lineatlas/error.hpp"
#include "temporary_folder.hpp"

namespace lineatlas::test {
namespace {

using compute::OpenClDevice;
using compute::Tuning;
using compute::TuningTable;

OpenClDevice device(const std::string& platform, const std::string& name, bool is_cpu) {
    OpenClDevice result;
    result.platform_name = platform;
    result.device_name = name;
    result.driver_version = "1.2";
    result.is_cpu = is_cpu;
    result.is_gpu = !is_cpu;
    return result;
}

const OpenClDevice a_cpu = device("Portable Computing Language", "pthread-x", true);
const OpenClDevice a_gpu = device("Some Platform", "Some Card", false);

constexpr const char* whole_row = R"([[row]]
match = {}
scan_tiles = true
scan_chunks = 16
scan_tile = 256
scan_per_item = 8
local_size = 64
block_local_size = 64
atlas_block = 4
atlas_vectors = false
depth_lanes = 1
depth_tile = 32
depth_workers = 4096
depth_clusters = 4294967295
depth_each = true
stroke_pixels = true
halo_lanes = 1
face_lanes = 1
face_chunks = 1024
face_lists = true
segment_block = 4
program_cache = true
)";

std::uint32_t local_size(const std::string& rows, const OpenClDevice& of) {
    return TuningTable{whole_row + rows, "table"}.values_for(of).local_size;
}

TEST(TuningTable, RowsThatFitGoOneOverTheOther) {
    EXPECT_EQ(local_size("", a_cpu), 64U);
    EXPECT_EQ(local_size("[[row]]\nmatch = { type = \"cpu\" }\nlocal_size = 8\n", a_cpu), 8U);
    EXPECT_EQ(local_size("[[row]]\nmatch = { type = \"cpu\" }\nlocal_size = 8\n", a_gpu), 64U);
    EXPECT_EQ(local_size("[[row]]\nmatch = { platform = \"some\", device = \"CARD\" }\n"
                         "local_size = 32\n",
                         a_gpu),
              32U);
    EXPECT_EQ(local_size("[[row]]\nmatch = { platform = \"some\", device = \"other\" }\n"
                         "local_size = 32\n",
                         a_gpu),
              64U);
    EXPECT_EQ(local_size("[[row]]\nmatch = { driver = \"1.2\" }\nlocal_size = 2\n"
                         "[[row]]\nmatch = { type = \"gpu\" }\nlocal_size = 3\n",
                         a_gpu),
              3U);
}

std::string complaint(const std::string& text) {
    try {
        TuningTable{text, "here/tuning.toml"}.values_for(a_gpu);
    } catch (const FileError& error) {
        return error.what();
    }
    return "none";
}

TEST(TuningTable, SaysWhatIsWrongAndWhere) {
    const std::string row = "[[row]]\nmatch = {}\n";
    const std::string place = "here/tuning.toml, line ";
    EXPECT_EQ(complaint(row + "local_size = 0\n"),
              place + "3: \"local_size\" must be a whole number from 1 to 1024");
    EXPECT_EQ(complaint(row + "local_size = 64.0\n"),
              place + "3: \"local_size\" must be a whole number from 1 to 1024");
    EXPECT_EQ(complaint(row + "scan_tile = 100\n"),
              place + "3: \"scan_tile\" must be one of 16 32 64 128 256 512 1024");
    EXPECT_EQ(complaint(row + "scan_tiles = 1\n"),
              place + "3: \"scan_tiles\" must be true or false");
    EXPECT_EQ(complaint(row + "\nlocalsize = 1\n"), place + "4: \"localsize\" is not known");
    EXPECT_EQ(complaint("[[row]]\nlocal_size = 1\n"),
              place + "1: \"row\" has no match; match = {} fits all");
    EXPECT_EQ(complaint("[[row]]\nmatch = { type = \"fpga\" }\n"),
              place + "2: \"type\" must be cpu, gpu or other");
    EXPECT_EQ(complaint("[[row]]\nmatch = { vendor = \"x\" }\n"),
              place + "2: \"vendor\" is no part of match: platform, device, driver, type");
    EXPECT_EQ(complaint("rows = 3\n"),
              place + "1: \"rows\" is not known here; a table has only [[row]]");
    EXPECT_EQ(complaint("[[row]\n").substr(0, place.size() + 2), place + "1:");
    EXPECT_EQ(complaint(row + "local_size = 64\n"),
              "here/tuning.toml: no row gives \"scan_tiles\" to opencl:Some Platform:Some Card");
    EXPECT_EQ(complaint(whole_row), "none");
}

TEST(Tuning, TheTableOfTheKernelFolderReplacesTheBuiltInOne) {
    const std::uint32_t built_in = compute::tuning_for(a_gpu).local_size;
    const TemporaryFolder folder;
    const EnvironmentVariable kernels{"LINEATLAS_KERNEL_DIR", folder.path().string()};
    EXPECT_EQ(compute::tuning_for(a_gpu).local_size, built_in);
    std::ofstream{folder.path() / "tuning.toml"} << whole_row
                                                 << "[[row]]\nmatch = {}\nlocal_size = 7\n";
    EXPECT_EQ(compute::tuning_for(a_gpu).local_size, 7U);
}

TEST(Tuning, TheBuiltInTableScansInChunksOnCpusAndTilesOnGpus) {
    EXPECT_FALSE(compute::tuning_for(a_cpu).scan_tiles);
    EXPECT_TRUE(compute::tuning_for(a_gpu).scan_tiles);
}

TEST(Tuning, NoLoopIsLongerThanADeviceRuns) {
    const Tuning tuning = compute::tuning_for(device("rusticl", "llvmpipe", true));
    EXPECT_LT(tuning.longest_chunk, 65'535U);
    EXPECT_LE(tuning.segment_block, 16U);
    EXPECT_GT(compute::tuning_for(a_cpu).longest_chunk, 65'535U);
}

TEST(Quirks, EachIsWholeAndHasALink) {
    for (const compute::Quirk& quirk : compute::known_quirks()) {
        SCOPED_TRACE(quirk.what);
        for (const std::string_view text :
             {quirk.platform, quirk.what, quirk.remedy, quirk.seen_with}) {
            EXPECT_FALSE(text.empty());
        }
        EXPECT_TRUE(quirk.link.starts_with("https://"));
    }
}

} // namespace
} // namespace lineatlas::test
