#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "io/part_paths.hpp"
#include "lineatlas/section.hpp"
#include "navigation.hpp"

namespace lineatlas::viewer {

/// Numbers of parts that are not shown; parts inside them are not shown either.
using HiddenParts = std::set<std::uint32_t>;

/// A pattern that means a name's letters alone.
std::string literal_pattern(const std::string& name);

/// The parts of a model: a tree with triangles at its leaves.
class Parts {
  public:
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    struct Part {
        std::string name;
        std::uint32_t parent = none; ///< stands before its parts
        std::uint32_t depth = 0;     ///< number of parts that it is in
        bool holds_others = false;
        Bounds bounds; ///< of its triangles, and of those in it
    };

    Parts() = default;
    explicit Parts(const LoadedMesh& loaded);

    /// In the order of a tree that is written down. Empty for a model that is one part.
    const std::vector<Part>& all() const { return all_; }
    /// The names of a part and of what it is in, as in `lineatlas draw --hide`.
    std::string path_of(std::uint32_t part) const;
    bool is_hidden(std::uint32_t part, const HiddenParts& hidden) const;
    /// MeshGroup::object of its triangles, each once: what rules for pens name.
    std::vector<std::string> objects_of(std::uint32_t part) const;
    /// What hides all but the part.
    HiddenParts all_but(std::uint32_t part) const;
    /// The mesh without hidden parts, its positions as they are.
    Mesh shown(const Mesh& mesh, const HiddenParts& hidden) const;
    /// The part whose triangle the ray meets first, of what is neither hidden nor taken away by
    /// planes.
    std::optional<std::uint32_t> pick(const Mesh& mesh, const Ray& ray, const HiddenParts& hidden,
                                      std::span<const SectionPlane> planes) const;

    /// A part as `lineatlas draw --hide` has it: a pattern that means it and what is in it.
    std::string pattern_of(std::uint32_t part) const;
    /// The parts that patterns mean; those that mean none are added to `unknown`.
    HiddenParts matching(std::span<const std::string> patterns,
                         std::vector<std::string>& unknown) const;

  private:
    bool is_in(std::uint32_t part, std::uint32_t whole) const;
    std::vector<bool> shown_paths(const HiddenParts& hidden) const;

    std::vector<Part> all_;
    PartPaths paths_;
    std::vector<std::uint32_t> part_of_path_;
    std::vector<std::set<std::string>> objects_of_path_;
};

} // namespace lineatlas::viewer
