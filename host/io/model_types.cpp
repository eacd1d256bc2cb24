#include "model_types.hpp"

#include <algorithm>

#include "extension.hpp"

namespace lineatlas {

const ModelType* find_model_type(std::string_view extension) {
    const auto* const found = std::ranges::find(model_types, extension, &ModelType::extension);
    return found != model_types.end() ? found : nullptr;
}

std::string model_extensions() {
    std::string text;
    for (const ModelType& type : model_types) {
        const bool last = &type == &model_types.back();
        text += text.empty() ? "" : last ? " and " : ", ";
        text += type.extension;
    }
    return text;
}

UsualUp usual_up(const std::filesystem::path& model) {
    const ModelType* const type = find_model_type(lower_extension(model));
    return type != nullptr ? type->up : UsualUp::y;
}

} // namespace lineatlas
