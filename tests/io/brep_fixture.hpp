#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <unistd.h>

#include "io/isolated.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"
#include "lineatlas/lines.hpp"
#include "mesh_volume.hpp"

namespace lineatlas::test {

namespace fs = std::filesystem;

class Brep : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("lineatlas_brep_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    LoadedMesh load(const std::string& name, std::string_view content,
                    const LoadOptions& options = {}, const ReadLimits& limits = {}) const {
        const fs::path path = folder_ / name;
        std::ofstream(path, std::ios::binary) << content;
        return load_mesh_isolated(path, limits, options);
    }

    /// True if the file is read. Expects that a refusal is one line.
    bool is_read(const std::string& name, std::string_view content,
                 const ReadLimits& limits = {}) const {
        try {
            const LoadedMesh loaded = load(name, content, {}, limits);
            extract_lines(loaded.mesh);
            return true;
        } catch (const FileError& error) {
            const std::string message = error.what();
            EXPECT_EQ(message.find('\n'), message.npos) << message;
            EXPECT_EQ(message.find("cannot read \"" + (folder_ / name).string() + "\": "), 0U)
                << message;
            return false;
        }
    }

    /// Reads the content with every `what` replaced by `by`; there must be some. All are replaced
    /// at once, because otherwise Open CASCADE doesn't end.
    void is_read_changed(const std::string& name, const std::string& content,
                         const std::string& what, const std::string& by) const {
        std::string text = content;
        for (std::size_t at = text.find(what); at != text.npos;
             at = text.find(what, at + by.size()))
            text.replace(at, what.size(), by);
        EXPECT_TRUE(text != content) << what;
        is_read(name, text, {.time = std::chrono::seconds{5}});
    }

    fs::path folder_;
};

/// Edges of the file by KnownEdge::Kind: sharp, smooth, seam, free.
using EdgeCounts = std::array<std::size_t, 4>;

inline EdgeCounts edges_of(const Mesh& mesh) {
    std::array<std::set<std::uint32_t>, 4> edges;
    for (const KnownEdge& edge : mesh.known_edges)
        edges[static_cast<std::size_t>(edge.kind)].insert(edge.edge);
    return {edges[0].size(), edges[1].size(), edges[2].size(), edges[3].size()};
}

} // namespace lineatlas::test
