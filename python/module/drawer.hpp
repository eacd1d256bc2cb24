#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/assembly.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/visibility.hpp"
#include "model.hpp"

namespace lineatlas::python {

/// A model and its lines, with the options by which the lines were found.
struct ModelLines {
    std::shared_ptr<const Model> model;
    LineSet lines;
    LineOptions options{}; ///< of the extraction
};

ModelLines find_lines(std::shared_ptr<const Model> model, const LineOptions& options,
                      const Progress& progress);

/// Intervals, and the lines that they are parts of.
struct FoundIntervals {
    std::shared_ptr<const ModelLines> subject;
    std::vector<Interval> intervals;
    std::vector<OutlinePart> outlines; ///< if the style has pens for outlines
};

/// A picture of 4 values per pixel, rows from the top. Colours are not multiplied by alpha.
struct Picture {
    std::vector<std::uint8_t> pixels;
    std::optional<bool> shows_lines{}; ///< nothing if that is not known
};

/// Draws a model. The first picture, and intervals of the method atlas, make a renderer with an
/// OpenGL context of its own. Intervals of the method exact need no OpenGL. Calls may come from any
/// thread and wait for each other. The thread's current context is restored after each call. In a
/// process that was forked after the construction, all calls but the destructor throw DeviceError.
class Drawer {
  public:
    Drawer(ModelLines subject, const DeviceOptions& device);
    ~Drawer();
    Drawer(const Drawer&) = delete;
    Drawer& operator=(const Drawer&) = delete;

    void set_subject(ModelLines subject);
    std::shared_ptr<const ModelLines> subject() const;
    bool is_changed() const;      ///< since it was made: moved, hidden, added or removed parts
    DeviceOptions device() const; ///< without OpenGL, which is current only during calls
    std::string description();
    std::string take_note(); ///< Renderer::note() if it has changed since the last call

    void prepare(const FrameOptions& options,
                 const Progress& progress); ///< see Renderer::prepare()
    Picture draw(const Camera& camera, FrameOptions options, bool transparent);
    /// The visible intervals of the lines; with `hidden` the hidden ones too.
    FoundIntervals intervals(const Camera& camera, FrameOptions options, bool hidden,
                             const Progress& progress);
    /// Renderer::pick(). `of` becomes the lines that the result refers to.
    std::optional<Pick> pick(const Camera& camera, glm::vec2 position, float radius,
                             std::shared_ptr<const ModelLines>& of);

    // See Renderer. A new subject resets all of them.
    void set_transforms(std::vector<glm::mat4> world_from_object);
    void set_positions(std::span<const glm::vec3> positions); ///< all positions of the mesh
    void set_hidden(std::vector<std::uint32_t> objects);

    /// Adds the objects of a model, with the subject's options for lines, and returns their
    /// numbers. Positions and triangles of its mesh follow those of earlier models.
    std::vector<std::uint32_t> add(const Model& part, const Progress& progress);
    void remove(std::uint32_t object);

    void close(); ///< frees everything; later calls throw UsageError

  private:
    class InUse;
    /// The objects that draw pictures.
    struct Pictures {
        gl::HeadlessContext context;
        Renderer renderer;
        std::unique_ptr<gl::Canvas> canvas{};
        std::set<std::string> known_pens{};

        explicit Pictures(const DeviceOptions& device) : renderer(device) {}
    };
    /// Each member is made when it is first needed. A renderer replaces LineVisibility, so that the
    /// model is not on the device twice.
    struct State {
        DeviceOptions device;
        std::string told{}; ///< the last Renderer::note()
        std::unique_ptr<LineVisibility> visibility{};
        std::unique_ptr<Pictures> pictures{};
    };

    /// The changes to the model as it was made; empty members: no change.
    struct Placement {
        std::vector<glm::vec3> vertices{}; ///< in place of LineSet::vertices
        Bounds bounds{};                   ///< of `vertices`
        std::vector<glm::mat4> transforms{};
        std::vector<std::uint32_t> hidden{};
    };
    std::shared_ptr<const ModelLines> placed(const Placement& placement) const;
    static void place(Renderer& renderer, const Placement& placement);
    void take(Placement next, std::shared_ptr<const ModelLines> moved);
    void start_assembly();
    /// Shows the changed assembly. The objects in `changed` stand where they were made.
    void take_parts(std::shared_ptr<const Model> model, std::span<const std::uint32_t> changed);

    std::unique_lock<std::mutex> lock() const;
    Pictures& make_pictures();
    LineVisibility& make_visibility();
    void set_pens(Pictures& pictures, const Style& style);
    static gl::Canvas& canvas(Pictures& pictures, glm::ivec2 size, int bits);

    mutable std::mutex mutex_;
    // Shared, because callers may still read them when they are replaced.
    std::shared_ptr<const ModelLines> made_;    ///< the lines as they were made
    std::shared_ptr<const ModelLines> subject_; ///< the lines at their places of now
    Placement placement_;
    std::optional<Assembly> assembly_; ///< from the first add() or remove() on
    std::unique_ptr<State> state_;
};

/// set_transforms(), set_positions(), hide(), add(), remove(), objects.
void bind_motion(pybind11::class_<Drawer>& renderer);
/// to_sheet().
void bind_sheets(pybind11::class_<Drawer>& renderer);
/// pick().
void bind_picking(pybind11::module_& module, pybind11::class_<Drawer>& renderer);

} // namespace lineatlas::python
