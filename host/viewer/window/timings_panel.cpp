#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

/// Colours of one lightness that can be told apart beside each other.
constexpr std::array<ImU32, 16> palette{
    IM_COL32(68, 119, 170, 255),  IM_COL32(238, 153, 68, 255),  IM_COL32(92, 158, 108, 255),
    IM_COL32(204, 102, 119, 255), IM_COL32(136, 102, 170, 255), IM_COL32(120, 190, 200, 255),
    IM_COL32(190, 170, 80, 255),  IM_COL32(150, 110, 90, 255),  IM_COL32(220, 150, 190, 255),
    IM_COL32(140, 145, 150, 255), IM_COL32(40, 84, 84, 255),    IM_COL32(160, 200, 120, 255),
    IM_COL32(110, 60, 90, 255),   IM_COL32(180, 180, 230, 255), IM_COL32(220, 120, 60, 255),
    IM_COL32(60, 60, 110, 255)};

ImU32 color_of(std::size_t stage) {
    return palette.at(stage % palette.size());
}

/// The top of the graph: a round number of milliseconds that nearly all frames are below. A frame
/// that built its kernels must not flatten all others.
double ceiling_of(const Timings& timings) {
    std::vector<double> totals;
    for (const Timings::Frame& frame : timings.frames()) totals.push_back(frame.total);
    std::ranges::sort(totals);
    const double highest = totals.empty() ? 1 : std::max(1.0, totals[totals.size() * 95 / 100]);
    double step = 1;
    while (step * 10 < highest) step *= 10;
    for (const double factor : {1, 2, 3, 4, 6, 8}) {
        if (step * factor >= highest) return step * factor;
    }
    return step * 10;
}

/// Draws a column per frame with its stages one above the other, the newest on the right.
void graph(const Ui& ui, const Timings& timings) {
    const ImVec2 size{ui.points(360), ui.points(110)};
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy(size);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 high{low.x + size.x, low.y + size.y};
    list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), ui.points(3));
    const double ceiling = ceiling_of(timings);
    const float column = size.x / static_cast<float>(Timings::kept);
    const auto height = [&](double ms) { return static_cast<float>(ms / ceiling) * size.y; };
    float x = high.x - column * static_cast<float>(timings.frames().size());
    for (const Timings::Frame& frame : timings.frames()) {
        float y = high.y;
        for (std::size_t stage = 0; stage < frame.stages.size(); ++stage) {
            const float top = std::max(y - height(frame.of(stage)), low.y);
            list.AddRectFilled({x, top}, {x + column, y}, color_of(stage));
            y = top;
        }
        x += column;
    }
    const float middle = 0.5F * (low.y + high.y);
    list.AddLine({low.x, middle}, {high.x, middle}, theme::colors().line);
    list.AddRect(low, high, theme::colors().line, ui.points(3));
    const float inset = ui.points(4);
    list.AddText({low.x + inset, low.y}, theme::colors().quiet,
                 fmt::format("{:g} ms", ceiling).c_str());
    list.AddText({low.x + inset, middle}, theme::colors().quiet,
                 fmt::format("{:g}", ceiling / 2).c_str());
}

void legend(const Ui& ui, const Timings& timings) {
    const float column = ui.points(184);
    std::size_t shown = 0;
    for (std::size_t stage = 0; stage < timings.stages().size(); ++stage) {
        if (shown % 2 == 1) ImGui::SameLine(column + ImGui::GetStyle().WindowPadding.x);
        ++shown;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float side = ui.points(10), drop = ui.points(4);
        ImGui::GetWindowDrawList()->AddRectFilled(
            {at.x, at.y + drop}, {at.x + side, at.y + drop + side}, color_of(stage), ui.points(2));
        ImGui::Dummy({side, side});
        ImGui::SameLine();
        const float start = ImGui::GetCursorPosX();
        ImGui::TextUnformatted(timings.stages()[stage].c_str());
        ImGui::SameLine(start + ui.points(108));
        ImGui::TextDisabled("%.2f", timings.median_of(stage));
    }
}

/// Draws how much the slowest kernels read and write, and how fast.
void kernel_table(const Ui& ui, const Timings& timings) {
    std::vector<Timings::Kernel> kernels = timings.kernels();
    std::ranges::sort(kernels, std::ranges::greater{}, &Timings::Kernel::milliseconds);
    constexpr std::size_t most = 12;
    if (kernels.size() > most) kernels.resize(most);
    const auto row = [&](const std::string& name, const std::array<std::string, 3>& cells) {
        ImGui::TextUnformatted(name.c_str());
        float right = ui.points(210);
        for (const std::string& cell : cells) {
            ImGui::SameLine(right - ImGui::CalcTextSize(cell.c_str()).x +
                            ImGui::GetStyle().WindowPadding.x);
            ImGui::TextDisabled("%s", cell.c_str());
            right += ui.points(72);
        }
    };
    row("kernel", {"ms", "MB", "GB/s"});
    for (const Timings::Kernel& kernel : kernels)
        row(kernel.name,
            {fmt::format("{:.3f}", kernel.milliseconds), fmt::format("{:.2f}", kernel.megabytes),
             fmt::format("{:.1f}", kernel.gigabytes_per_second())});
    if (kernels.empty()) ImGui::TextDisabled("No kernel has run");
}

} // namespace

void draw_timings(Ui& ui, Area canvas) {
    if (!ui.timings) return;
    const Timings& timings = ui.session.timings;
    ImGui::SetNextWindowPos(
        {canvas.low.x + ui.points(12), canvas.low.y + canvas.size.y - ui.points(12)},
        ImGuiCond_Always, {0, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.points(6));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.points(12), ui.points(10)});
    ImGui::Begin("timings", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PopStyleVar(3);
    ImGui::PushFont(ui.bold);
    const double total = timings.median_total();
    ImGui::TextUnformatted(total > 0 ? fmt::format("{:.1f} ms a frame", total).c_str()
                                     : "Move the camera to see timings");
    ImGui::PopFont();
    graph(ui, timings);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.points(6), ui.points(2)});
    if (ui.kernels)
        kernel_table(ui, timings);
    else
        legend(ui, timings);
    ImGui::PopStyleVar();
    if (toggle(ui, "timings.kernels", "Kernels", ui.kernels)) ui.kernels = !ui.kernels;
    tip(ui, "Bytes that each kernel reads and writes in the last frame, and how fast");
    ImGui::SameLine();
    ImGui::BeginDisabled(timings.profiles().empty());
    if (button(ui, "timings.trace", "Save a trace")) save_as(ui, SavedKind::trace);
    tip(ui, "These frames for Perfetto or chrome://tracing");
    ImGui::EndDisabled();
    ImGui::End();
}

} // namespace lineatlas::viewer
