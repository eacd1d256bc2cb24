#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "io/reader_process.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"
#include "shown.hpp"

namespace lineatlas::viewer {

/// A file or a built-in scene to be shown.
struct ModelSource {
    std::vector<std::filesystem::path> files; ///< side by side, see join_models()
    std::string scene;                        ///< if there is no file
    std::optional<glm::vec3> up{}; ///< none: as the model stands; set once the model is loaded
    LineOptions lines{};

    ReadLimits read{}; ///< of each file

    std::string name() const; ///< for people
    std::string stem() const; ///< of files that are saved
};

struct Model {
    ModelSource source;
    std::shared_ptr<const Mesh> whole; ///< as in the file
    Parts parts;                       ///< of it
    Shown shown;                       ///< of it
    std::vector<SectionPlane> planes;  ///< planes that have cut it, in its coordinates
    std::shared_ptr<const Mesh> mesh;  ///< what is shown
    LineSet lines;                     ///< of what is shown
    std::vector<glm::vec3> framed;     ///< points that a camera for the whole model must show
    glm::dvec3 origin{0};              ///< of meshes, in the file's coordinates
    std::optional<double> unit{};      ///< of the file, in millimetres
    std::vector<std::string> notes;    ///< what was repaired in the file
    std::optional<View> view;          ///< a scene's own
};

/// Reads models on a thread of its own, one at a time.
class Loader {
  public:
    /// `wake` is called on the loader's thread whenever there is something to see.
    explicit Loader(std::function<void()> wake) : wake_(std::move(wake)) {}
    ~Loader() { cancel(); }
    Loader(const Loader&) = delete;
    Loader& operator=(const Loader&) = delete;

    /// Sets how models are read, on the loader's thread. By default these are files and built-in
    /// scenes.
    using Reader = std::function<std::shared_ptr<Model>(const ModelSource&)>;
    void set_reader(Reader reader) { reader_ = std::move(reader); }

    /// Starts reading a model, in place of the one that is being read.
    void start(ModelSource source);
    /// Starts finding lines for the same model with something else shown. Some part must stay
    /// shown.
    void start(std::shared_ptr<const Model> model, Shown shown);
    /// Forgets the model that is being read. Its thread cannot be stopped; it reads to the end, and
    /// the result is discarded.
    void cancel();

    bool busy() const { return job_ != nullptr; }
    /// Whether to show progress: for files, and for work that has taken a while.
    bool shows_progress() const;
    std::string name() const; ///< of what is being read
    /// The parts and cuts that lines are being found for; null while a model is read or nothing is
    /// done.
    const Shown* shown() const;
    std::string stage() const; ///< for people, as in "Reading the file"

    /// The model, or the reason why there is none. Returned once, when it is ready.
    using Result = std::variant<std::shared_ptr<Model>, std::string>;
    std::optional<Result> take();

    /// Whether any thread is at work, also one whose reading was cancelled.
    static bool any_thread();

  private:
    struct Job;
    void start(std::shared_ptr<Job> job);
    static void run(const std::shared_ptr<Job>& job);

    static std::shared_ptr<Model> read(const ModelSource& source);

    std::function<void()> wake_;
    Reader reader_ = read;
    std::shared_ptr<Job> job_;
};

} // namespace lineatlas::viewer
