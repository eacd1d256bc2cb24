#include "table_list.hpp"

#include <algorithm>

namespace lineatlas::compute {

Buffer::~Buffer() {
    if (counted_in_ != nullptr) counted_in_->bytes -= size_;
}

void TableList::add(Device& device, Buffer& buffer, const TableName& name) {
    std::deque<TableMemory>& all = device.tables_;
    auto found = std::ranges::find(all, name.name, &TableMemory::name);
    if (found == all.end()) found = all.insert(found, {name.name, name.purpose.what});
    found->bytes += buffer.size_;
    buffer.counted_in_ = &*found;
}

std::unique_ptr<Buffer> allocate(Device& device, std::size_t bytes, const TableName& name) {
    std::unique_ptr<Buffer> buffer =
        for_purpose(name.purpose, [&] { return device.allocate(bytes); });
    TableList::add(device, *buffer, name);
    return buffer;
}

std::uint64_t bytes_for(const Device& device, std::initializer_list<const Purpose*> purposes) {
    std::uint64_t sum = 0;
    for (const TableMemory& table : device.tables()) {
        if (std::ranges::find(purposes, table.purpose, &Purpose::what) != purposes.end())
            sum += table.bytes;
    }
    return sum;
}

} // namespace lineatlas::compute
