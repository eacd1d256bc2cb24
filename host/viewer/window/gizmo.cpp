// The model's axes in the picture's lower left corner; a click on one looks along it.
#include <algorithm>
#include <array>
#include <string>

#include <glm/geometric.hpp>

#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

struct Arm {
    glm::vec3 axis;
    std::string name; ///< "X", or "-X" for the other end
    ImU32 color;
    glm::vec2 at{0}; ///< in points from the middle, y down
    float toward_eye = 0;
};

/// The arms, the farthest first.
std::array<Arm, 6> arms_of(const View& view, float length) {
    constexpr std::array<ImU32, 3> colors{IM_COL32(176, 48, 40, 255), IM_COL32(40, 112, 48, 255),
                                          IM_COL32(44, 98, 158, 255)};
    const glm::vec3 ahead = glm::normalize(view.target - view.eye);
    const glm::vec3 right = glm::normalize(glm::cross(ahead, view.up));
    const glm::vec3 above = glm::cross(right, ahead);
    std::array<Arm, 6> arms;
    for (std::size_t i = 0; i < arms.size(); ++i) {
        Arm& arm = arms.at(i);
        const auto axis = static_cast<int>(i % 3);
        arm.axis = glm::vec3{0};
        arm.axis[axis] = i < 3 ? 1.0F : -1.0F;
        arm.name = std::string{i < 3 ? "" : "-"} + static_cast<char>('X' + axis);
        arm.color = colors.at(i % 3);
        arm.at = length * glm::vec2{glm::dot(arm.axis, right), -glm::dot(arm.axis, above)};
        arm.toward_eye = -glm::dot(arm.axis, ahead);
    }
    std::ranges::sort(arms, {}, &Arm::toward_eye);
    return arms;
}

void draw(const Ui& ui, const Arm& arm, ImVec2 middle, bool hovered) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{middle.x + arm.at.x, middle.y + arm.at.y};
    const bool positive = arm.name.size() == 1;
    const float radius = ui.points(positive || hovered ? 9.0F : 6.0F);
    if (positive) list.AddLine(middle, end, arm.color, ui.points(2));
    list.AddCircleFilled(end, radius, positive || hovered ? arm.color : theme::colors().panel);
    list.AddCircle(end, radius, arm.color, 0, ui.points(1.5F));
    if (!positive && !hovered) return;
    const ImVec2 size = ImGui::CalcTextSize(arm.name.c_str());
    list.AddText({end.x - size.x / 2, end.y - size.y / 2}, IM_COL32_WHITE, arm.name.c_str());
}

} // namespace

void draw_gizmo(Ui& ui, Area canvas) {
    if (ui.session.model() == nullptr || ui.session.recording()) return;
    const float side = ui.points(84), reach = ui.points(9);
    const glm::vec2 low = canvas.low + glm::vec2{ui.points(8), canvas.size.y - side - ui.points(8)};
    ImGui::SetNextWindowPos({low.x, low.y});
    ImGui::SetNextWindowSize({side, side});
    ImGui::Begin("axes", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    const ImVec2 middle{low.x + side / 2, low.y + side / 2};
    std::array<Arm, 6> arms = arms_of(ui.session.navigation.view(), 0.5F * side - reach);
    std::array<bool, 6> hovered{};
    for (std::size_t i = arms.size(); i-- > 0;) { // the nearest is pressed first
        const Arm& arm = arms.at(i);
        ImGui::SetCursorScreenPos({middle.x + arm.at.x - reach, middle.y + arm.at.y - reach});
        const std::string id = "axis." + arm.name;
        if (ImGui::InvisibleButton(id.c_str(), {2 * reach, 2 * reach}))
            ui.session.look_from(arm.axis);
        ui.spots.note(id);
        hovered.at(i) = ImGui::IsItemHovered();
        tip(ui, ("Look from " + arm.name).c_str());
    }
    ImGui::GetWindowDrawList()->PushClipRectFullScreen();
    for (std::size_t i = 0; i < arms.size(); ++i) draw(ui, arms.at(i), middle, hovered.at(i));
    ImGui::GetWindowDrawList()->PopClipRect();
    ImGui::End();
}

} // namespace lineatlas::viewer
