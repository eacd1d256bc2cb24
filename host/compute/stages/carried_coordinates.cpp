#include "carried_coordinates.hpp"

namespace lineatlas::compute {

void CarriedCoordinates::release() {
    for (std::unique_ptr<Buffer>* buffer : tables(*this)) buffer->reset();
    count_ = 0;
}

void CarriedCoordinates::make_room(std::unique_ptr<Buffer>& buffer, std::uint64_t words) {
    const std::uint64_t bytes = words * sizeof(la_uint);
    if (buffer && buffer->size() >= bytes) return;
    const bool grows = buffer != nullptr;
    buffer.reset(); // it may not fit beside another
    buffer = allocate(device_, grows ? room_to_grow(device_, bytes) : bytes, purpose::segments);
}

void CarriedCoordinates::find(const SegmentTable& table, std::uint32_t first,
                              const ClippedTable& clipped, glm::vec2 viewport, float limit) {
    first_ = first;
    count_ = table.segment_count - first;
    arcs_ = &clipped.arcs;
    if (count_ == 0) return forget();
    const std::uint64_t n = count_, words = std::uint64_t{table.candidates.count} * LA_MEMORY_WORDS;
    if (!memory_ || memory_->size() < words * sizeof(la_uint)) {
        make_room(memory_, words);
        device_.clear(*memory_, words * sizeof(la_uint));
    }
    for (std::unique_ptr<Buffer>* each :
         {&lengths_, &found_, &kept_, &breaks_, &means_, &pieces_, &list_, &shifts_}) {
        make_room(*each, n + 1);
    }
    make_room(recalled_, 2 * n);
    make_room(carried_, 2 * n);
    stages_.carry({.table = table,
                   .first = first,
                   .count = count_,
                   .clipped = clipped,
                   .viewport = viewport,
                   .frame = frame_++,
                   .limit = limit,
                   .memory = *memory_,
                   .lengths = *lengths_,
                   .found = *found_,
                   .kept = *kept_,
                   .breaks = *breaks_,
                   .means = *means_,
                   .recalled = *recalled_,
                   .list = *list_,
                   .pieces = *pieces_,
                   .shifts = *shifts_,
                   .carried = *carried_});
}

void CarriedCoordinates::apply(Buffer& runs, Buffer& record, std::uint32_t run_capacity) {
    if (count_ == 0) return;
    stages_.carry_runs({.first = first_,
                        .arcs = *arcs_,
                        .carried = *carried_,
                        .record = record,
                        .run_capacity = run_capacity,
                        .runs = runs});
}

std::uint64_t CarriedCoordinates::bytes() const {
    std::uint64_t sum = 0;
    for (const std::unique_ptr<Buffer>* buffer : tables(*this)) {
        if (*buffer) sum += (*buffer)->size();
    }
    return sum;
}

} // namespace lineatlas::compute
