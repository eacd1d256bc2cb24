#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

/// Whether two views show the same.
bool same(const View& a, const View& b);

/// All that a viewer shows and lets one change, without its window: model, camera, settings,
/// device, and the pictures of the last frame. Nothing a person does here throws: what fails is
/// told by `messages`, and all is as it was.
class Session {
  public:
    /// In a current GL context, which stays current. `wake`: see Loader. The writer must outlive
    /// it.
    Session(const DeviceOptions& device, ImageWriter& writer, std::function<void()> wake);

    Settings settings;
    Navigation navigation;
    Messages messages;
    Timings timings;
    Loader loader;
    RecentFiles recent{{}};        ///< models; nothing is kept unless that is asked for
    bool profile = false;          ///< keep timings
    std::optional<glm::vec3> up{}; ///< of files to be opened; none: as each stands
    LineOptions line_options{};    ///< the same
    ReadLimits read_limits{};      ///< of files, those of pens too

    /// A model, a session or a style (.toml) or a camera (.json), by extension.
    void open(const std::filesystem::path& file) { open(std::vector{file}); }
    /// Several at once: models side by side in one scene, what else there is in turn.
    void open(const std::vector<std::filesystem::path>& files);
    bool adds = false; ///< models that are opened come to those that are there
    void open_scene(const std::string& name);
    /// The file of the model once more, seen as now.
    void reload();
    /// Reads the file again where it is another one than at the last two looks: while it is still
    /// being written it changes from one look to the next.
    void look_at_file();
    /// Builds kernels again where files in LINEATLAS_KERNEL_DIR were written.
    void look_at_kernels();
    /// Whether either look may find anything.
    bool has_files_to_look_at() const;
    /// The view from which the next model is seen first.
    void open_first_camera(const std::filesystem::path& file);
    const Model* model() const { return model_.get(); }
    glm::dvec3 origin() const; ///< of what is shown, in the file's coordinates

    /// Which parts are shown from now on; refused where nothing would be left.
    void show_parts(ShownParts shown);
    /// What is cut from now on.
    void set_cuts(std::vector<Cut> cuts);
    /// A new cut across the middle of the model, that takes what lies before it; refused where
    /// there are as many as there may be.
    void add_cut();
    /// The cut whose handle is near a point of the canvas, nearer than `reach` pixels.
    std::optional<std::size_t> cut_at(glm::dvec2 point, double reach) const;
    /// Moves a cut so that its handle follows from one point of the canvas to another.
    void drag_cut(std::size_t cut, glm::dvec2 from, glm::dvec2 to);
    const Bounds& whole_bounds() const { return whole_bounds_; } ///< of the model, uncut
    /// From which angle on edges are creases, degrees; nothing: as the model looks.
    void set_crease(std::optional<float> degrees);
    /// Where silhouettes run.
    void set_silhouettes(Silhouettes silhouettes);
    /// Forgets what is being read or found: all stays as it was.
    void cancel_loading();
    /// The part that is seen at a point of the canvas.
    std::optional<std::uint32_t> part_at(glm::dvec2 point) const;
    PartNumbers selected{};
    /// The part in place of those that are selected, or, if it `adds`, beside them; one that is
    /// selected already is no more then.
    void select(std::optional<std::uint32_t> part, bool adds = false);
    void hide_selected();
    void isolate_selected(); ///< they are shown alone
    void frame_selected();

    /// Takes `settings` as a step of their own, and a camera at rest as one of its. Cheap where
    /// nothing has changed.
    void note_step();
    void undo();
    void redo();
    void camera_back();
    void camera_forward();

    /// The name or path of one; empty: plain lines.
    void use_style(const std::string& name);
    void use_device(const DeviceOptions& device);
    const DeviceOptions& device() const { return device_; }
    std::string device_description() const; ///< with a line of what is not as one may expect

    void glide_to(StandardView view);
    void look_from(glm::vec3 direction); ///< a unit vector from the model to the eye
    void toggle_projection();            ///< perspective or orthographic
    void fit();                          ///< all of the model, from where the eye looks
    /// What is seen at a point of the canvas, or else the model's centre.
    glm::dvec3 point_at(glm::dvec2 point) const;
    Camera camera() const; ///< there must be a model

    /// Begins or ends measuring: points are picked then, each two are a distance.
    void toggle_measuring();
    bool measuring() const { return measuring_; }
    /// Takes the corner or point of the model that is seen there.
    void measure_at(glm::dvec2 point);
    /// The first of two points, in the model's coordinates.
    const std::optional<glm::dvec3>& measured_from() const { return measured_from_; }
    /// A length of the model with its unit, if its file says one.
    std::string length_text(double length) const;

    /// Files at `path`; a type of picture or paths by its extension. False if that failed.
    bool save_picture(const std::filesystem::path& path);
    /// The same as a drawing for paper, a plotter or a laser, or a sheet of several views.
    bool export_to(const std::filesystem::path& path, const ExportOptions& options);
    /// The page that export_to() would write, with its views as pictures, or why there is none.
    struct Preview {
        ExportPage page{};
        std::vector<std::unique_ptr<gl::Canvas>> pictures{}; ///< of its views
        std::string problem{};
    };
    /// As it was drawn last for the options that are wanted; `pixels`: of the page's longer side.
    /// It is drawn anew by draw_preview() where preview_due() says so.
    const Preview& preview(const ExportOptions& options, int pixels);
    const std::string& preview_problem() const { return preview_.problem; }
    bool preview_due() const;
    void draw_preview();
    bool save_style(const std::filesystem::path& path);
    bool save_camera(const std::filesystem::path& path);
    /// What `timings` keeps, as Trace Event Format.
    bool save_trace(const std::filesystem::path& path);
    /// All of it, as a file that open() and `lineatlas draw` take.
    bool save_session(const std::filesystem::path& path);
    /// Where the session was opened or saved last; empty: nowhere yet.
    const std::filesystem::path& session_path() const { return session_path_; }

    /// Keeps the camera under the first name that is free.
    void add_bookmark();
    void go_to_bookmark(std::size_t bookmark);

    /// Pictures of a moving camera, into a new folder of `folder`; about `frames` in all. A turn
    /// about the model, or the way through the kept views, which must be two at least.
    enum class Move { turntable, kept_views };
    void start_recording(Move move, const std::filesystem::path& folder, int frames);
    const std::optional<Recording>& recording() const { return recording_; }
    /// Draws the next picture of a recording. After the last one there is none any more, and the
    /// folder is returned.
    std::optional<std::filesystem::path> record_picture();
    /// Those that are drawn stay.
    void cancel_recording();
    /// Where `ffmpeg` is installed.
    void make_video_of(const std::filesystem::path& folder);

    void resize(glm::ivec2 pixels);
    glm::ivec2 size() const { return size_; }
    /// Something but the camera has changed.
    void changed() {
        stale_ = step_due_ = true;
        ++revision_;
    }
    /// Shows a model that has been loaded, and moves glides and notices on by `seconds`.
    void advance(double seconds);
    /// Whether draw() has something to do.
    bool stale() const;
    void draw();
    /// Whether the picture is at rest and could become exact.
    bool can_refine() const;
    /// The next picture is exact, unless something moves or changes before.
    void refine() { refine_due_ = true; }
    bool refining() const { return refine_due_; }
    /// Whether that may take so long that people should know.
    bool refines_slowly() const { return refine_seconds_ > 0.3; }
    /// Asked all along while a picture becomes exact; true: it stays as it was. May be none.
    std::function<bool()> interrupted{};
    /// Whether the picture that is shown is drawn by `exact` in place of the segment atlas.
    bool refined() const { return refined_; }
    /// How long the last picture took until it was shown: what the next ones of a movement leave
    /// out.
    void note_duration(double seconds);
    /// What gave way in the picture that is shown.
    Economy economy() const { return economy_; }
    /// Of the pictures that are shown: smaller than the window's part where pixels give way.
    glm::ivec2 size_of_pictures() const;
    /// Adds the timings that have arrived to `timings`. Returns whether there were any.
    bool take_timings();
    /// Whether timings of frames that were drawn have not arrived yet.
    bool timings_due() const { return timings_due_ > 0; }
    /// The picture of a side; null before the first.
    const gl::Canvas* picture(std::size_t side) const { return canvases_.at(side).get(); }
    const FrameStats& stats() const { return stats_; }
    std::uint64_t frames_drawn() const { return frames_drawn_; }

  private:
    void show(std::shared_ptr<Model> model);
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
    void draw_side(std::size_t side, const Camera& camera);
    void draw_refined(const Camera& camera);
    bool sketch_due() const;
    void renew_sketch();
    bool attempt(const std::function<void()>& action);

    ImageWriter& writer_;
    DeviceOptions device_;
    std::unique_ptr<Renderer> renderer_;
    /// Of long lines alone, for movements: made when a large model needs it.
    std::unique_ptr<Renderer> sketch_;
    std::optional<View> sketched_; ///< where lines were long; nothing: not those of this model
    std::shared_ptr<Model> model_;
    Bounds whole_bounds_;
    std::optional<ShownInWords> awaited_; ///< of the model that is being read
    struct AwaitedSession {
        std::filesystem::path path;
        SessionFile session;
    };
    std::optional<AwaitedSession> awaited_session_; ///< likewise
    std::filesystem::path session_path_;
    glm::ivec2 size_{0, 0};
    std::array<std::unique_ptr<gl::Canvas>, 2> canvases_;
    FrameStats stats_;
    std::filesystem::path first_camera_;
    using WriteTimes = std::vector<std::filesystem::file_time_type>;
    WriteTimes read_times_{}, looked_times_{}; ///< of the model's files
    KernelFolder kernels_;
    std::optional<View> drawn_view_;
    bool stale_ = true, step_due_ = true;
    bool keeps_view_ = false; ///< of what is being loaded
    History<Settings, same> steps_;
    History<View, same> views_;
    bool moving_ = false; ///< the last picture was one of a movement, averaged with the one before
    Economy economy_ = Economy::none; ///< of the last picture
    Pace pace_;                       ///< of this model
    std::optional<Recording> recording_;
    /// What a preview is of.
    struct Previewed {
        ExportOptions options{};
        View view{};
        glm::ivec2 window{0};
        std::uint64_t revision = 0;
        int pixels = 0;
    };
    static bool shows_same(const Previewed& a, const Previewed& b);
    ExportedDrawing exported() const;
    std::optional<Previewed> preview_wanted_, preview_drawn_;
    Preview preview_;
    std::uint64_t revision_ = 0; ///< of settings and model
    bool measuring_ = false;
    std::optional<glm::dvec3> measured_from_;
    bool refine_due_ = false, refined_ = false;
    bool tells_pace_ = true; ///< the last picture was drawn as those of a movement are
    static constexpr double unknown_seconds = 1;
    double refine_seconds_ = unknown_seconds; ///< what it took last, of this model
    double wanted_rest_ = 0;                  ///< seconds since what is to be shown was changed
    Shown wanted_{};                          ///< as it was then
    int timings_due_ = 0;
    std::uint64_t frames_drawn_ = 0;
};

} // namespace lineatlas::viewer
