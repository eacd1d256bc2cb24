#include "obj.hpp"

#include <algorithm>
#include <istream>
#include <map>
#include <span>
#include <streambuf>
#include <utility>

#include <tiny_obj_loader.h>

#include "obj_materials.hpp"
#include "obj_text.hpp"

namespace lineatlas {

namespace {

/// A stream over text that is already in memory. It knows how far it was read.
class TextStream : private std::streambuf, public std::istream {
  public:
    explicit TextStream(std::string& text) : std::istream(static_cast<std::streambuf*>(this)) {
        setg(text.data(), text.data(), text.data() + text.size());
    }
    std::size_t place() const { return static_cast<std::size_t>(gptr() - eback()); }
};

/// Takes tinyobjloader's callbacks, which come in the order of the file, so that negative indices
/// and the current group need no second pass.
class ObjSoup {
  public:
    ObjSoup(const SourceFile& source, ObjText& text, const ObjMaterials& materials,
            const ProgressPart& progress)
        : source_(source), text_(text), materials_(materials), progress_(progress),
          stream_(text.text) {}

    Soup read() {
        tinyobj::callback_t callbacks;
        callbacks.vertex_cb = [](void* self, float, float, float, float) {
            static_cast<ObjSoup*>(self)->add_vertex();
        };
        callbacks.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
            static_cast<ObjSoup*>(self)->element({corners, static_cast<std::size_t>(count)});
        };
        callbacks.usemtl_cb = [](void* self, const char* name, int) {
            static_cast<ObjSoup*>(self)->material_ = name;
            static_cast<ObjSoup*>(self)->group_known_ = false;
        };
        callbacks.group_cb = [](void* self, const char** names, int count) {
            static_cast<ObjSoup*>(self)->set_group({names, static_cast<std::size_t>(count)});
        };
        callbacks.object_cb = [](void* self, const char* name) {
            static_cast<ObjSoup*>(self)->set_object(name);
        };
        if (!tinyobj::LoadObjWithCallback(stream_, callbacks, this))
            throw read_error(source_.path, "tinyobjloader refuses it");

        // A single group without a name says nothing about the mesh.
        const bool nameless = soup_.groups.size() == 1 && soup_.groups[0].object.empty() &&
                              soup_.groups[0].material.empty();
        if (nameless) {
            soup_.groups.clear();
            soup_.face_group.clear();
        }
        return std::move(soup_);
    }

  private:
    void add_vertex() {
        soup_.positions.push_back(text_.positions.at(soup_.positions.size()));
        tell();
    }

    void tell() {
        constexpr std::uint32_t every = 1U << 14U;
        if (++told_ % every != 0) return;
        progress_(static_cast<float>(stream_.place()) / static_cast<float>(text_.text.size()));
    }

    void element(std::span<const tinyobj::index_t> corners) {
        tell();
        corners_.clear();
        const bool nothing = corners.size() == 1 && corners[0].vertex_index == 0;
        if (!nothing)
            for (const tinyobj::index_t& corner : corners)
                corners_.push_back(vertex(corner.vertex_index));
        if (is_polyline()) {
            soup_.polylines.push_back(corners_);
            return;
        }
        soup_.add_face(corners_);
        soup_.face_group.push_back(current_group());
    }

    /// The callback runs when the whole line and its end have been read.
    bool is_polyline() {
        const auto& ends = text_.polyline_ends;
        if (next_polyline_ == ends.size() || ends[next_polyline_] + 1 != stream_.place())
            return false;
        ++next_polyline_;
        return true;
    }

    std::uint32_t vertex(int index) const {
        const auto count = static_cast<long long>(soup_.positions.size());
        const long long from_zero = index < 0 ? count + index : static_cast<long long>(index) - 1;
        // Positive indices may refer to later vertices. They are checked when all vertices are
        // read.
        const bool ahead = index > 0 && from_zero >= count;
        if (index == 0 || from_zero < 0 || (ahead && from_zero >= vertices_in_file()))
            throw read_error(source_.path,
                             "line " + std::to_string(line()) + " refers to vertex " +
                                 std::to_string(index) + ", the file has " +
                                 std::to_string(index < 0 ? count : vertices_in_file()) +
                                 (index < 0 ? " before it" : ""));
        return static_cast<std::uint32_t>(from_zero);
    }

    long long vertices_in_file() const {
        if (vertices_in_file_ < 0) {
            vertices_in_file_ = text_.text.starts_with("v ") ? 1 : 0;
            for (std::size_t at = text_.text.find("\nv "); at != std::string::npos;
                 at = text_.text.find("\nv ", at + 1))
                ++vertices_in_file_;
        }
        return vertices_in_file_;
    }

    std::size_t line() const {
        const auto read = text_.text.begin() + static_cast<std::ptrdiff_t>(stream_.place());
        return static_cast<std::size_t>(std::count(text_.text.begin(), read, '\n'));
    }

    void set_object(std::string name) {
        object_ = std::move(name);
        group_.clear();
        group_known_ = false;
    }

    void set_group(std::span<const char*> names) {
        group_.clear();
        for (const char* name : names) {
            if (!group_.empty()) group_ += ' ';
            group_ += name;
        }
        group_known_ = false;
    }

    std::uint32_t current_group() {
        if (group_known_) return group_index_;
        const bool both = !object_.empty() && !group_.empty() && object_ != group_;
        const std::string name = both ? object_ + '/' + group_ : object_.empty() ? group_ : object_;
        const auto [entry, added] = group_indices_.try_emplace(
            {name, material_}, static_cast<std::uint32_t>(soup_.groups.size()));
        if (added)
            soup_.groups.push_back(
                {.object = name, .material = material_, .color = materials_.color(material_)});
        group_index_ = entry->second;
        group_known_ = true;
        return group_index_;
    }

    const SourceFile& source_;
    ObjText& text_;
    const ObjMaterials& materials_;
    const ProgressPart& progress_;
    std::uint32_t told_ = 0; ///< vertices and faces of which progress was told
    TextStream stream_;
    Soup soup_;
    std::vector<std::uint32_t> corners_;
    std::size_t next_polyline_ = 0;
    mutable long long vertices_in_file_ = -1;
    std::string object_;
    std::string group_;
    std::string material_;
    std::map<std::pair<std::string, std::string>, std::uint32_t> group_indices_;
    std::uint32_t group_index_ = 0;
    bool group_known_ = false;
};

} // namespace

Soup read_obj(SourceFile source, const MaterialFiles& files, const ProgressPart& progress) {
    ObjText text = reduce_obj(source);
    source.bytes = std::string(); // frees the second copy of a large model
    const ObjMaterials materials(files.contents);
    Soup soup = ObjSoup(source, text, materials, progress).read();
    soup.notes.insert(soup.notes.end(), files.notes.begin(), files.notes.end());
    return soup;
}

} // namespace lineatlas
