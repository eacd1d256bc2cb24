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

/// The kinds of lines and angles that a model's lines are found with.
struct ModelLines {
    std::shared_ptr<const Model> model;
    LineSet lines;
    LineOptions options{}; ///< that they were found with
};

ModelLines find_lines(std::shared_ptr<const Model> model, const LineOptions& options,
                      const Progress& progress);

/// Intervals, and the lines whose they are.
struct FoundIntervals {
    std::shared_ptr<const ModelLines> subject;
    std::vector<Interval> intervals;
    std::vector<OutlinePart> outlines; ///< of a style with pens for them
};

/// Pixels from the top left, 4 values each, colour not multiplied by alpha.
struct Picture {
    std::vector<std::uint8_t> pixels;
    std::optional<bool> shows_lines{}; ///< if that is known
};

/// What draws a model. A renderer with an OpenGL context of its own is made for the first picture,
/// or for intervals of method atlas; those of method exact need no OpenGL. Calls may come from any
/// thread and wait for each other; whatever context is current on the thread is again afterwards.
/// All but its end throw DeviceError in a process that was forked after it was made.
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
    std::string take_note(); ///< Renderer::note(), once, and again if it is another

    void prepare(const FrameOptions& options, const Progress& progress); ///< as Renderer has it
    Picture draw(const Camera& camera, FrameOptions options, bool transparent);
    /// What is visible of the lines, and with `hidden` the rest too.
    FoundIntervals intervals(const Camera& camera, FrameOptions options, bool hidden,
                             const Progress& progress);
    /// Renderer::pick(), and the lines it is of.
    std::optional<Pick> pick(const Camera& camera, glm::vec2 position, float radius,
                             std::shared_ptr<const ModelLines>& of);

    // As Renderer has them; from a new subject on all is as it was made.
    void set_transforms(std::vector<glm::mat4> world_from_object);
    void set_positions(std::span<const glm::vec3> positions); ///< of all of the mesh
    void set_hidden(std::vector<std::uint32_t> objects);

    /// Adds a model's objects, found as those of the subject were; gives their numbers. What
    /// lines refer to of its mesh stands behind that of the models before.
    std::vector<std::uint32_t> add(const Model& part, const Progress& progress);
    void remove(std::uint32_t object);

    void close(); ///< gives back all that it holds; later calls throw UsageError

  private:
    class InUse;
    /// What draws pictures.
    struct Pictures {
        gl::HeadlessContext context;
        Renderer renderer;
        std::unique_ptr<gl::Canvas> canvas{};
        std::set<std::string> known_pens{};

        explicit Pictures(const DeviceOptions& device) : renderer(device) {}
    };
    /// Each is made when it is first needed. The renderer finds all that the other does: with it
    /// the model need not be on the device twice.
    struct State {
        DeviceOptions device;
        std::string told{}; ///< of Renderer::note()
        std::unique_ptr<LineVisibility> visibility{};
        std::unique_ptr<Pictures> pictures{};
    };

    /// What is not as the model was made; empty: nothing.
    struct Placement {
        std::vector<glm::vec3> vertices{}; ///< in place of LineSet::vertices
        Bounds bounds{};                   ///< of these
        std::vector<glm::mat4> transforms{};
        std::vector<std::uint32_t> hidden{};
    };
    std::shared_ptr<const ModelLines> placed(const Placement& placement) const;
    static void place(Renderer& renderer, const Placement& placement);
    void take(Placement next, std::shared_ptr<const ModelLines> moved);
    void start_assembly();
    /// The assembly has changed: shows it, with these objects where they were made.
    void take_parts(std::shared_ptr<const Model> model, std::span<const std::uint32_t> changed);

    std::unique_lock<std::mutex> lock() const;
    Pictures& make_pictures();
    LineVisibility& make_visibility();
    void set_pens(Pictures& pictures, const Style& style);
    static gl::Canvas& canvas(Pictures& pictures, glm::ivec2 size, int bits);

    mutable std::mutex mutex_;
    // Callers may read these while they are replaced.
    std::shared_ptr<const ModelLines> made_;    ///< as it was made
    std::shared_ptr<const ModelLines> subject_; ///< where it is now
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
