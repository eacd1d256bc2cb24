#include <algorithm>

#include "glpasses/interop/connect.hpp"
#include "lineatlas/compute_device.hpp"
#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

constexpr const char* best_mode = "automatic";

std::vector<DeviceChoice> find_devices() {
    std::vector<DeviceChoice> choices{{"automatic", {}}};
    for (const compute::OpenClDevice& device : compute::list_opencl_devices()) {
        choices.push_back({device.name(), {.device = device.name()}});
    }
    for (const compute::DeviceKind& kind : compute::device_kinds()) {
        if (kind.name != "opencl") choices.push_back({kind.name, {.compute = kind.name}});
    }
    return choices;
}

bool same(const DeviceOptions& a, const DeviceOptions& b) {
    return a.compute == b.compute && a.device == b.device;
}

void use(Ui& ui, const DeviceOptions& device) {
    ui.do_later("Switching the device",
                [&session = ui.session, device] { session.use_device(device); });
}

} // namespace

void draw_device_rows(Ui& ui) {
    if (ui.devices.empty()) ui.devices = find_devices();
    const DeviceOptions& device = ui.session.device();
    const auto chosen = std::ranges::find_if(
        ui.devices, [&](const DeviceChoice& choice) { return same(choice.options, device); });
    const std::string shown = chosen != ui.devices.end() ? chosen->label : device.device;
    choice(
        ui, "device", "Runs on", shown, ui.devices,
        [](const DeviceChoice& item) { return item.label; },
        [&](const DeviceChoice& item) { return same(item.options, device); },
        [&](const DeviceChoice& item) { use(ui, item.options); },
        "Which processor finds the lines; automatic: the fastest one that works");
    std::vector<std::string> modes{""};
    for (const interop::SharingMode mode : interop::all_modes) modes.emplace_back(name_of(mode));
    const auto label_of = [](const std::string& mode) { return mode.empty() ? best_mode : mode; };
    choice(
        ui, "interop", "Sharing", label_of(device.interop), modes, label_of,
        [&](const std::string& mode) { return mode == device.interop; },
        [&](const std::string& mode) {
            DeviceOptions wanted = device;
            wanted.interop = mode;
            use(ui, wanted);
        },
        "How that processor and the graphics card share buffers");
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("%s", ui.session.device_description().c_str());
    ImGui::PopTextWrapPos();
}

} // namespace lineatlas::viewer
