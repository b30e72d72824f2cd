#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace abrazo {

/// Rows of one type: an owned vector, or a view of memory owned elsewhere (a mapped file). Copy on write: the
/// first write to a view makes an owned vector. Reading never copies.
template <typename Item>
class Column {
 public:
  using value_type = Item;
  using size_type = std::size_t;
  using difference_type = std::ptrdiff_t;
  using reference = Item&;
  using const_reference = const Item&;
  using iterator = Item*;
  using const_iterator = const Item*;

  Column() = default;
  Column(std::vector<Item> items) : own_(std::move(items)) {}  // NOLINT(google-explicit-constructor)
  /// A view of rows that `holder` keeps alive.
  Column(std::span<const Item> rows, std::shared_ptr<const void> holder)
      : view_(rows), holder_(std::move(holder)) {}

  bool is_view() const { return holder_ != nullptr; }
  std::size_t size() const { return is_view() ? view_.size() : own_.size(); }
  bool empty() const { return size() == 0; }
  const Item* data() const { return is_view() ? view_.data() : own_.data(); }
  const Item* begin() const { return data(); }
  const Item* end() const { return data() + size(); }
  const Item& operator[](std::size_t row) const { return data()[row]; }
  const Item& front() const { return *data(); }
  const Item& back() const { return data()[size() - 1]; }

  Item* data() { return own().data(); }
  Item* begin() { return data(); }
  Item* end() { return own().data() + own_.size(); }
  Item& operator[](std::size_t row) { return own()[row]; }
  Item& front() { return own().front(); }
  Item& back() { return own().back(); }
  void reserve(std::size_t rows) { own().reserve(rows); }
  void resize(std::size_t rows) { own().resize(rows); }
  void assign(std::size_t rows, const Item& item) { own().assign(rows, item); }
  void clear() { own().clear(); }
  void push_back(const Item& item) { own().push_back(item); }
  void pop_back() { own().pop_back(); }
  /// As std::vector's; `at` is an iterator of this column.
  template <typename Iterator>
  void insert(const Item* at, Iterator first, Iterator last) {
    const std::ptrdiff_t row = at - std::as_const(*this).data();
    own().insert(own_.begin() + row, first, last);
  }

  friend bool operator==(const Column& a, const Column& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  std::vector<Item>& own() {
    if (is_view()) {
      own_.assign(view_.begin(), view_.end());
      view_ = {};
      holder_.reset();
    }
    return own_;
  }

  std::vector<Item> own_;
  std::span<const Item> view_;
  std::shared_ptr<const void> holder_;
};

}  // namespace abrazo
