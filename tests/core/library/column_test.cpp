#include "core/library/store/column.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>

namespace abrazo::column_test {
namespace {

class ColumnView : public testing::Test {
 protected:
  const std::shared_ptr<std::array<int, 4>> rows =
      std::make_shared<std::array<int, 4>>(std::array{1, 2, 3, 4});
  Column<int> view{std::span<const int>(*rows), rows};
};

TEST_F(ColumnView, ReadsWhereTheRowsAre) {
  EXPECT_TRUE(view.is_view());
  EXPECT_EQ(view.size(), 4U);
  EXPECT_EQ(std::as_const(view).data(), rows->data());
  EXPECT_EQ(std::as_const(view).back(), 4);
}

TEST_F(ColumnView, KeepsTheRowsAsLongAsItOrACopyOfItNeedsThem) {
  const std::weak_ptr<std::array<int, 4>> watched = rows;
  EXPECT_EQ(watched.use_count(), 2);
  const Column<int> copy = view;
  EXPECT_EQ(watched.use_count(), 3);
  view.push_back(5);
  EXPECT_EQ(watched.use_count(), 2) << "whoever writes lets go";
}

TEST_F(ColumnView, WritingToACopyChangesNeitherTheRowsNorOtherCopies) {
  Column<int> copy = view;
  copy[2] = 30;
  EXPECT_EQ(copy, Column<int>({1, 2, 30, 4}));
  EXPECT_FALSE(copy.is_view());
  EXPECT_EQ(view, Column<int>({1, 2, 3, 4}));
  EXPECT_EQ((*rows)[2], 3);
}

TEST_F(ColumnView, InsertsAtAPlaceOfItsOwnEvenWhenItWasAViewUntilThen) {
  const std::array<int, 2> added = {8, 9};
  view.insert(std::as_const(view).data() + 1, added.begin(), added.end());
  EXPECT_EQ(view, Column<int>({1, 8, 9, 2, 3, 4}));
}

TEST(Column, OfItsOwnIsAVector) {
  Column<int> column;
  EXPECT_TRUE(column.empty());
  EXPECT_FALSE(column.is_view());
  column.assign(2, 7);
  column.push_back(8);
  column.pop_back();
  column.resize(3);
  EXPECT_EQ(column, Column<int>({7, 7, 0}));
  column.clear();
  EXPECT_TRUE(column.empty());
}

}  // namespace
}  // namespace abrazo::column_test
