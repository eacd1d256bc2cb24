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

/// Numbers of parts. They stand for the parts in them too.
using PartNumbers = std::set<std::uint32_t>;

/// Which parts are shown.
struct ShownParts {
    PartNumbers hidden{}; ///< parts that are not shown
    PartNumbers only{};   ///< only these parts are shown; empty: all

    bool operator==(const ShownParts&) const = default;
};

/// A pattern that matches this name and no other.
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
        Bounds bounds; ///< of its triangles, and of those of the parts in it
    };

    Parts() = default;
    explicit Parts(const LoadedMesh& loaded);

    /// All parts, each before the parts in it. Empty for a model that is one part.
    const std::vector<Part>& all() const { return all_; }
    /// The names of a part and of the parts that contain it, as in `lineatlas draw --hide`.
    std::string path_of(std::uint32_t part) const;
    /// Whether a part is one of these, or in one of them.
    bool is_among(std::uint32_t part, const PartNumbers& parts) const;
    bool is_shown(std::uint32_t part, const ShownParts& shown) const {
        return (shown.only.empty() || is_among(part, shown.only)) && !is_among(part, shown.hidden);
    }
    /// MeshGroup::object of its triangles, each once. Rules for pens name these.
    std::vector<std::string> objects_of(std::uint32_t part) const;
    /// The choice that shows only these parts. Hidden parts within them stay hidden.
    ShownParts alone(const PartNumbers& parts, const ShownParts& before) const;
    /// The mesh without parts that are not shown, its positions as they are.
    Mesh shown(const Mesh& mesh, const ShownParts& shown) const;
    /// The part whose triangle the ray meets first, among parts that are shown and not cut away.
    std::optional<std::uint32_t> pick(const Mesh& mesh, const Ray& ray, const ShownParts& shown,
                                      std::span<const SectionPlane> planes) const;

    /// The pattern for `lineatlas draw --hide` that means a part and the parts in it.
    std::string pattern_of(std::uint32_t part) const;
    /// The parts that patterns mean. Patterns that mean none are added to `unknown`.
    PartNumbers matching(std::span<const std::string> patterns,
                         std::vector<std::string>& unknown) const;

  private:
    bool is_in(std::uint32_t part, std::uint32_t whole) const;
    std::vector<bool> shown_paths(const ShownParts& shown) const;

    std::vector<Part> all_;
    PartPaths paths_;
    std::vector<std::uint32_t> part_of_path_;
    std::vector<std::set<std::string>> objects_of_path_;
};

} // namespace lineatlas::viewer
