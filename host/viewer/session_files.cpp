// A Session as a file, and the views it keeps.
#include <algorithm>

#include <fmt/format.h>

#include "command_line/values.hpp"
#include "saving.hpp"
#include "session.hpp"
#include "style/frame_settings.hpp"

namespace lineatlas::viewer {
namespace {

/// The settings as options of `lineatlas draw`, without those that follow from others.
std::vector<SessionFile::Option> options_of(const Settings& settings, glm::ivec2 size) {
    std::vector<SessionFile::Option> options;
    const auto add = [&](const char* key, std::string value) {
        options.push_back({key, {std::move(value)}});
    };
    add("size", fmt::format("{}x{}", size.x, size.y));
    if (settings.lines) add("lines", line_kinds_to_text(*settings.lines));
    const Side& side = settings.sides[0];
    // Without a method the tool takes `exact`, as a picture at rest does here.
    if (side.method == Method::atlas && settings.exact_at_rest) return options;
    add("method", name_of(side.method));
    add("probes", std::to_string(side.probes));
    add("depth-scale", std::to_string(side.depth_scale));
    add("step", fmt::format("{}", side.step));
    return options;
}

} // namespace

void Session::open_session(const std::filesystem::path& file) {
    attempt([&] {
        SessionFile session = read_session(file);
        ShownInWords words;
        for (const SessionFile::Option& option : session.options) {
            if (option.key == "hide") words.hidden = option.values;
            if (option.key == "only") words.only = option.values;
            if (option.key == "section")
                for (const std::string& text : option.values) words.cuts.push_back({text, true});
            if (option.key == "crease" && option.values.front() != "auto")
                words.crease = std::stof(option.values.front());
            if (option.key == "silhouettes")
                words.silhouettes = parse_silhouettes(option.key, option.values.front());
        }
        for (const std::string& text : session.sections_off) words.cuts.push_back({text, false});
        ModelSource source{.files = session.models,
                           .scene = session.scene,
                           .up = up,
                           .lines = line_options,
                           .read = read_limits};
        if (!session.views.empty()) source.up = session.views.front().up;
        if (source.files.empty() && !source.up) source.up = glm::vec3{0, 1, 0};
        forget_awaited();
        awaited_ = {.words = std::move(words), .session = AwaitedSession{file, std::move(session)}};
        loader.start(std::move(source));
    });
}

/// Takes the settings of a session file for the current model.
void Session::take_session(const SessionFile& session) {
    FrameSettings frame;
    std::vector<std::string> unknown;
    for (const SessionFile::Option& option : session.options) {
        const auto known = std::ranges::find(frame_settings(), option.key, &FrameSetting::key);
        if (known != frame_settings().end())
            known->set(frame, value_from_text(option.values.front()));
        else if (option.key != "size" && option.key != "hide" && option.key != "only" &&
                 option.key != "section" && option.key != "crease" && option.key != "silhouettes")
            unknown.push_back(option.key);
    }
    const FrameOptions options = frame.for_sequence();
    settings.sides[0] = {.method = options.method,
                         .probes = options.probes,
                         .depth_scale = options.depth_scale,
                         .step = options.step};
    settings.exact_at_rest = !frame.method;
    settings.lines = options.lines;
    if (attempt([&] { load_pens(session.style); })) {
        settings.style = session.style;
        settings.style_name = session.style_name;
    }
    settings.bookmarks.clear();
    if (!session.views.empty())
        settings.bookmarks.assign(session.views.begin() + 1, session.views.end());
    if (!unknown.empty())
        messages.notice(fmt::format(
            "The viewer leaves out \"{}\" of this session; the tool draws it", unknown.front()));
}

SessionFile Session::session_file() const {
    SessionFile session{.models = model_->source.files,
                        .scene = model_->source.scene,
                        .options = options_of(settings, size_),
                        .style_name = settings.style_name,
                        .style = settings.style};
    const ShownInWords words = in_words();
    std::vector<std::string> cuts;
    for (const ShownInWords::Plane& cut : words.cuts)
        (cut.on ? cuts : session.sections_off).push_back(cut.text);
    if (!words.hidden.empty()) session.options.push_back({"hide", words.hidden});
    if (!words.only.empty()) session.options.push_back({"only", words.only});
    if (!cuts.empty()) session.options.push_back({"section", std::move(cuts)});
    if (words.crease) session.options.push_back({"crease", {fmt::format("{}", *words.crease)}});
    if (words.silhouettes)
        session.options.push_back({"silhouettes", {word_of(*words.silhouettes)}});
    session.views.push_back(named_view(navigation.goal(), origin()));
    session.views.insert(session.views.end(), settings.bookmarks.begin(), settings.bookmarks.end());
    return session;
}

bool Session::save_session(const std::filesystem::path& path) {
    if (model_ == nullptr) return false;
    return attempt([&] {
        save_text(write_session(session_file(), path.parent_path()), path);
        session_path_ = path;
        recent.add(path);
        messages.notice("Saved " + path.string());
    });
}

void Session::add_bookmark() {
    if (model_ == nullptr) return;
    std::vector<SessionFile::NamedView>& kept = settings.bookmarks;
    std::string name;
    for (std::size_t number = kept.size() + 1; name.empty(); ++number) {
        name = fmt::format("View {}", number);
        if (std::ranges::find(kept, name, &SessionFile::NamedView::name) != kept.end())
            name.clear();
    }
    kept.push_back(named_view(navigation.goal(), origin(), name));
    messages.notice("Kept as " + name);
    changed();
}

void Session::go_to_bookmark(std::size_t bookmark) {
    if (bookmark >= settings.bookmarks.size()) return;
    navigation.glide_to(view_of(settings.bookmarks[bookmark], origin()));
}

} // namespace lineatlas::viewer
