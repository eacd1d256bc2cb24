#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drawing_thread.hpp"
#include "economy.hpp"
#include "exporting.hpp"
#include "files.hpp"
#include "glpasses/canvas.hpp"
#include "history.hpp"
#include "io/image_writer.hpp"
#include "lineatlas/renderer.hpp"
#include "loader.hpp"
#include "messages.hpp"
#include "navigation.hpp"
#include "recording.hpp"
#include "settings.hpp"
#include "sources/kernel_folder.hpp"
#include "timings.hpp"

namespace lineatlas::viewer {

/// Whether two views are the same.
bool same(const View& a, const View& b);

/// Session::work() while a file is saved or a video made, which can be cancelled.
inline constexpr const char *saving_work = "Saving", *video_work = "Making a video";

/// Everything that a viewer shows and lets one change, without its window: model, camera, settings,
/// device, and the pictures of the last frame. Actions of a person never throw: `messages` reports
/// a failure, and nothing has changed then.
class Session {
  public:
    /// `context`: the GL context of its drawing thread. Other threads call `wake` when there is
    /// something new to show. The context and the writer must outlive the session.
    Session(const DeviceOptions& device, ImageWriter& writer, SharedContext& context,
            std::function<void()> wake);
    ~Session();

    Settings settings;
    Navigation navigation;
    Messages messages;
    Timings timings;
    Loader loader;
    RecentFiles recent{{}};        ///< models; without a store nothing is kept
    bool profile = false;          ///< keep timings
    std::optional<glm::vec3> up{}; ///< up in files to be opened; none: as each model stands
    LineOptions line_options{};    ///< the same
    ReadLimits read_limits{};      ///< limits of reading files, also those of pens

    /// Opens a model, a session or style (.toml) or a camera (.json), by extension.
    void open(const std::filesystem::path& file) { open(std::vector{file}); }
    /// Opens several files: models side by side in one scene, other files in turn.
    void open(const std::vector<std::filesystem::path>& files);
    bool adds = false; ///< opened models are added to the current ones
    void open_scene(const std::string& name);
    /// Reads the model's file again and keeps the view.
    void reload();
    /// Reads the file again if it has changed and then stayed the same for two looks. A file that
    /// is still being written changes from one look to the next.
    void look_at_file();
    /// Builds kernels again where files in LINEATLAS_KERNEL_DIR were written.
    void look_at_kernels();
    /// Whether either look may find anything.
    bool has_files_to_look_at() const;
    /// Sets the first view of the next model.
    void open_first_camera(const std::filesystem::path& file);
    const Model* model() const { return model_.get(); }
    glm::dvec3 origin() const; ///< origin of the model shown, in the file's coordinates

    /// Sets which parts are shown. Refused if none would be left.
    void show_parts(ShownParts shown);
    /// Sets the cuts.
    void set_cuts(std::vector<Cut> cuts);
    /// Adds a cut through the middle of the model that takes away the side nearer to the eye.
    /// Refused if there are as many cuts as allowed.
    void add_cut();
    /// The cut whose handle is near a point of the canvas, nearer than `reach` pixels.
    std::optional<std::size_t> cut_at(glm::dvec2 point, double reach) const;
    /// Moves a cut so that its handle follows from one point of the canvas to another.
    void drag_cut(std::size_t cut, glm::dvec2 from, glm::dvec2 to);
    const Bounds& whole_bounds() const { return whole_bounds_; } ///< of the model, uncut
    /// Sets the angle in degrees from which on edges are creases. Nothing: chosen by the model.
    void set_crease(std::optional<float> degrees);
    /// Sets where silhouettes run.
    void set_silhouettes(Silhouettes silhouettes);
    /// Cancels reading a model or finding lines. Everything stays as it was.
    void cancel_loading();
    /// The part that is seen at a point of the canvas.
    std::optional<std::uint32_t> part_at(glm::dvec2 point) const;
    PartNumbers selected{};
    /// Selects a part in place of the selected ones. With `adds` it is added to them, or removed
    /// from them if it is selected already.
    void select(std::optional<std::uint32_t> part, bool adds = false);
    void hide_selected();
    void isolate_selected(); ///< shows them alone
    void frame_selected();

    /// Notes changed settings as a step to undo, and a changed camera at rest as another step.
    /// Cheap if nothing has changed.
    void note_step();
    void undo();
    void redo();
    void camera_back();
    void camera_forward();

    /// Takes a style by its name or path; empty: plain lines.
    void use_style(const std::string& name);
    /// Whether it could.
    bool use_device(const DeviceOptions& device);
    const DeviceOptions& device() const { return device_; }
    /// The device in words, with a line more if it is not the one that was expected.
    const std::string& device_description() const { return description_; }

    void glide_to(StandardView view);
    void look_from(glm::vec3 direction); ///< a unit vector from the model to the eye
    void toggle_projection();            ///< perspective or orthographic
    void fit();                          ///< shows all of the model, in the same direction
    /// The point of the model seen at a point of the canvas, or the model's centre if nothing is
    /// seen there.
    glm::dvec3 point_at(glm::dvec2 point) const;
    Camera camera() const; ///< there must be a model

    /// Begins or ends measuring, in which two picked points make a distance.
    void toggle_measuring();
    bool measuring() const { return measuring_; }
    /// Picks the corner or point of the model that is seen at a point of the canvas.
    void measure_at(glm::dvec2 point);
    /// The first of two points, in the model's coordinates.
    const std::optional<glm::dvec3>& measured_from() const { return measured_from_; }
    /// A length of the model with its unit, if its file says one.
    std::string length_text(double length) const;

    /// Saves a picture or paths, by extension, under a free name of `folder` that is made of the
    /// model's name. The drawing thread does that, and a message tells when it is done.
    void save_picture(const std::filesystem::path& folder, const std::string& extension);
    /// Likewise saves a drawing for paper, a plotter or a laser, or a sheet of several views.
    void export_to(const std::filesystem::path& path, const ExportOptions& options);
    /// Whether there is a file of that path, or one is being saved to it.
    bool is_taken(const std::filesystem::path& path) const;
    /// A path in `folder` that is not taken, made of the model's name. There must be a model.
    std::filesystem::path free_path(const std::filesystem::path& folder,
                                    const std::string& extension) const;
    /// What the drawing thread does that people wait for, such as saving_work; empty: nothing, or
    /// nothing that takes long.
    std::string work() const;
    /// The share of it that is done; below 0: not known.
    float work_done() const { return work_done_; }
    /// Whether cancel_work() has an effect on work().
    bool can_cancel_work() const;
    /// Gives up all files that are being saved, of which nothing is written; or the video that is
    /// being made.
    void cancel_work();
    /// Saves all files that are to be saved, and waits for that. Nothing else is done any more.
    /// Returns the messages of those that failed.
    std::vector<std::string> finish_saving();
    /// The page that export_to() would write, with its views as pictures.
    struct Preview {
        ExportPage page{};
        std::vector<std::unique_ptr<gl::Canvas>> pictures{}; ///< of its views
        std::string problem{};
    };
    /// The preview as it was drawn last, and the options of the next one. `pixels`: length of the
    /// page's longer side. draw_preview() begins to draw it anew if preview_due().
    const Preview& preview(const ExportOptions& options, int pixels);
    const std::string& preview_problem() const { return preview_.problem; }
    /// Whether the preview is of the wanted options.
    bool has_preview() const;
    bool preview_due() const;
    void draw_preview();
    /// Saves the style. Returns false if that failed, as do the others below.
    bool save_style(const std::filesystem::path& path);
    bool save_camera(const std::filesystem::path& path);
    /// Saves the frames of `timings` in Trace Event Format.
    bool save_trace(const std::filesystem::path& path);
    /// Saves the whole session as a file that open() and `lineatlas draw` take.
    bool save_session(const std::filesystem::path& path);
    /// Where the session was opened or saved last; empty: nowhere yet.
    const std::filesystem::path& session_path() const { return session_path_; }

    /// Keeps the camera under the first name that is free.
    void add_bookmark();
    void go_to_bookmark(std::size_t bookmark);

    /// Starts recording about `frames` pictures of a moving camera into a new folder of `folder`.
    /// The camera turns about the model, or goes through the kept views, which must be at least
    /// two.
    enum class Move { turntable, kept_views };
    void start_recording(Move move, const std::filesystem::path& folder, int frames);
    const std::optional<Recording>& recording() const { return recording_; }
    /// Begins the next picture of a recording, unless something else is being drawn. After the last
    /// one the recording ends, and a video is made of it if `ffmpeg` is installed.
    void record_picture();
    /// Ends a recording. Pictures that were drawn stay.
    void cancel_recording();

    void resize(glm::ivec2 pixels);
    glm::ivec2 size() const { return size_; }
    /// Says that something other than the camera has changed.
    void changed() {
        stale_ = step_due_ = true;
        ++revision_;
    }
    /// Shows a model that has been loaded, and moves glides and notices on by `seconds`.
    void advance(double seconds);
    /// Whether draw() has something to do.
    bool stale() const;
    /// Begins the next picture. take_picture() shows it.
    void draw();
    /// Whether the drawing thread is at work. No picture is begun before it is done.
    bool drawing() const { return picture_ != nullptr || !tasks_.empty(); }
    /// Waits at most `longest` for the picture that is being drawn. Shows it if it is done, and
    /// returns whether it was.
    bool take_picture(std::chrono::milliseconds longest = std::chrono::milliseconds{0});
    /// Ends the task of the drawing thread that is done, and begins the next one. Returns whether
    /// there is something new to show.
    bool take_task();
    /// Whether the picture is at rest and could become exact.
    bool can_refine() const;
    /// Makes the next picture exact, unless something moves or changes before.
    void refine() { refine_due_ = true; }
    bool refining() const;
    /// Whether the picture that is shown is drawn by `exact` in place of the segment atlas.
    bool refined() const { return shown_.refined; }
    /// Notes how long a picture took. The next pictures of a movement leave out as much as that
    /// asks for.
    void note_duration(double seconds);
    /// The step of economy of the picture that is shown.
    Economy economy() const { return shown_.economy; }
    /// Where the picture that is shown belongs in the present view, in pixels of the canvas from
    /// its lower left corner. It is moved and scaled as the target of the camera is.
    struct Placement {
        glm::dvec2 low, high;
        bool moved; ///< false: it fills the canvas
    };
    Placement placement() const;
    /// Adds the timings that have arrived to `timings`. Returns whether there were any.
    bool take_timings();
    /// Whether timings of frames that were drawn have not arrived yet.
    bool timings_due() const { return timings_due_ > 0; }
    /// The picture of a side; null before the first.
    const gl::Canvas* picture(std::size_t side) const { return shown_.canvases.at(side).get(); }
    const FrameStats& stats() const { return shown_.stats; }
    std::uint64_t frames_drawn() const { return frames_drawn_; }

  private:
    /// Work of the drawing thread beside pictures.
    struct Task {
        std::string what{};           ///< Session::work()
        std::function<void()> work{}; ///< throws Error
        /// Called on the window's thread when `work` is done. `worked`: it has not thrown.
        std::function<void(bool worked)> then{};
        std::filesystem::path path{}; ///< of the file that is saved
        std::exception_ptr failure{};
        bool begun = false;
        std::chrono::steady_clock::time_point added = std::chrono::steady_clock::now();
    };
    void add_task(Task task);
    /// Adds one that saves a file. `save` gets the function that says whether to go on, and throws
    /// Cancelled if not.
    using SaveFile = std::function<void(const std::function<bool()>& goes_on)>;
    void add_saving(const std::filesystem::path& path, SaveFile save);
    static void run(Task& task);
    void make_video_of(const std::filesystem::path& folder);
    /// Choices for a model that is being read.
    struct AwaitedSession {
        std::filesystem::path path;
        SessionFile session;
    };
    struct Awaited {
        std::optional<ShownInWords> words{};
        std::optional<AwaitedSession> session{};
        bool keeps_view = false;
    };
    void show(std::shared_ptr<Model> model);
    void take_shown(const std::shared_ptr<Model>& model, const Awaited& awaited);
    void give_lines(const std::shared_ptr<const Model>& model);
    bool is_other_file_coming() const;
    void show_wanted();
    void restart_stale_job(double seconds);
    void forget_awaited();
    void await_the_same();
    ShownInWords in_words() const;
    void take_words(const ShownInWords& words);
    void take(const Settings* step);
    void glide_to(const View* step);
    void open_models(const std::vector<std::filesystem::path>& files);
    void open_session(const std::filesystem::path& file);
    SessionFile session_file() const;
    void take_session(const SessionFile& session);
    void open_camera(const std::filesystem::path& file);
    std::optional<View> take_first_camera();
    void load_pens(const Style& style);
    using Canvases = std::array<std::unique_ptr<gl::Canvas>, 2>;
    /// A picture with everything that the drawing thread needs. It is the thread's until it is
    /// done.
    struct Picture {
        View view{};
        glm::ivec2 window{0}; ///< pixels of the canvas that it is drawn for
        Camera camera{};
        std::array<FrameOptions, 2> options{}; ///< of its sides
        bool split = false;                    ///< there are two
        Economy economy = Economy::none;
        bool refined = false;
        bool stays = false;      ///< nothing is drawn: what there is stays
        bool tells_pace = false; ///< it is drawn as those of a movement are
        bool renews_sketch = false;
        std::shared_ptr<const Model> model{};
        Canvases canvases{};
        FrameStats stats{};
        double seconds = 0; ///< that it took
        std::string description{};
        std::exception_ptr failure{};
        bool interrupted = false;
    };
    void draw_picture(Picture& picture);
    void draw_side(Picture& picture, std::size_t side);
    void draw_refined(Picture& picture);
    bool sketch_due() const;
    void renew_sketch(const Picture& picture);
    void make_renderer();
    bool attempt(const std::function<void()>& action);
    std::string describe_device() const;

    ImageWriter& writer_;
    DeviceOptions device_;
    DrawingThread drawing_;
    // The thread's own, as what they made is:
    std::unique_ptr<Renderer> renderer_;
    std::shared_ptr<const Model> in_renderer_; ///< whose lines `renderer_` has; null: not known
    /// Draws only long lines, for movements. Made when a large model needs it.
    std::unique_ptr<Renderer> sketch_;
    std::optional<View> sketched_; ///< the view by which long lines were chosen; nothing: not
                                   ///< chosen for this model
    std::shared_ptr<Model> model_;
    Bounds whole_bounds_;
    Awaited awaited_; ///< for the model that the loader reads
    /// A model that the loader has read and that a task takes.
    struct Coming {
        std::shared_ptr<Model> model;
        Awaited awaited;
    };
    std::optional<Coming> coming_;
    std::filesystem::path session_path_;
    glm::ivec2 size_{0, 0};
    Picture shown_;
    std::unique_ptr<Picture> picture_; ///< that is being drawn
    std::deque<Task> tasks_;           ///< the first may have begun; a picture goes before it
    std::atomic<float> work_done_{-1}; ///< of the first
    std::atomic<bool> ends_{false};    ///< the session; long work stops
    std::atomic<bool> stops_video_{false};
    std::shared_ptr<std::atomic<bool>> saving_cancelled_ =
        std::make_shared<std::atomic<bool>>(false); ///< of the tasks that save now
    Canvases spare_;                                ///< of the picture before, for the next one
    std::atomic<bool> outdated_{false}; ///< the picture that is being drawn; it may stop
    std::string description_;           ///< of the device, when a picture was drawn last
    std::filesystem::path first_camera_;
    using WriteTimes = std::vector<std::filesystem::file_time_type>;
    WriteTimes read_times_{}, looked_times_{}; ///< of the model's files
    KernelFolder kernels_;
    std::optional<View> drawn_view_;
    bool stale_ = true, step_due_ = true;
    History<Settings, same> steps_;
    History<View, same> views_;
    bool moving_ = false; ///< the last picture was one of a movement, averaged with the one before
    Pace pace_;           ///< of this model
    std::optional<Recording> recording_;
    std::uint64_t recordings_ = 0; ///< that were begun
    /// What a preview was made of.
    struct Previewed {
        ExportOptions options{};
        View view{};
        glm::ivec2 window{0};
        std::uint64_t revision = 0;
        int pixels = 0;
    };
    static bool shows_same(const Previewed& a, const Previewed& b);
    ExportedDrawing exported() const;
    Preview make_preview(const Previewed& wanted, const ExportedDrawing& drawing);
    std::optional<Previewed> preview_wanted_, preview_begun_, preview_drawn_;
    Preview preview_, preview_before_; ///< the thread frees the latter
    std::uint64_t revision_ = 0;       ///< of settings and model
    bool measuring_ = false;
    std::optional<glm::dvec3> measured_from_;
    bool refine_due_ = false;
    bool refine_failed_ = false; ///< the exact picture of this view, which is not tried again
    double wanted_rest_ = 0;     ///< seconds since what is to be shown was changed
    Shown wanted_{};             ///< as it was then
    int timings_due_ = 0;
    std::uint64_t frames_drawn_ = 0;
};

} // namespace lineatlas::viewer
