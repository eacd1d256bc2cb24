// A device's list of the memory of its tables.
#include <gtest/gtest.h>

#include "compute/stages/table_room.hpp"

namespace lineatlas::compute {
namespace {

constexpr Purpose first{"the first", "none"}, second{"the second", "none"};
constexpr TableName table_a{"a", first}, table_b{"b", first}, table_c{"c", second};

class TableMemories : public testing::Test {
  protected:
    std::uint64_t bytes(std::string_view name) const {
        for (const TableMemory& table : device_->tables())
            if (table.name == name) return table.bytes;
        return 0;
    }

    std::unique_ptr<Device> device_ = make_device("cpp");
};

TEST_F(TableMemories, AreThoseOfTheBuffersThatThereAre) {
    Table a{*device_, table_a};
    EXPECT_TRUE(device_->tables().empty()) << "a table without room is none";
    a.fit(100);
    EXPECT_EQ(bytes("a"), 100U);
    a.fit(50);
    EXPECT_EQ(bytes("a"), 100U);
    a.fit(300);
    EXPECT_EQ(bytes("a"), 300U) << "the one before has gone";
    a.release();
    EXPECT_EQ(bytes("a"), 0U);
    EXPECT_EQ(device_->tables().size(), 1U) << "the name stays";
}

TEST_F(TableMemories, AddUpByNameAndByPurpose) {
    Table one{*device_, table_a}, other{*device_, table_a}, b{*device_, table_b},
        c{*device_, table_c};
    one.fit(100);
    other.fit(200);
    b.fit(1000);
    c.fit(10'000);
    EXPECT_EQ(bytes("a"), 300U);
    EXPECT_EQ(bytes_for(*device_, {&first}), 1300U);
    EXPECT_EQ(bytes_for(*device_, {&second}), 10'000U);
    EXPECT_EQ(bytes_for(*device_, {&first, &second}), 11'300U);
}

TEST_F(TableMemories, GoWithATableThatMoves) {
    Table a{*device_, table_a};
    a.fit(100);
    {
        const Table moved = std::move(a);
        EXPECT_EQ(bytes("a"), 100U);
    }
    EXPECT_EQ(bytes("a"), 0U);
}

} // namespace
} // namespace lineatlas::compute
