// Owning pointer to the state of a move-only object of the library.
#pragma once

#include <cassert>
#include <memory>
#include <utility>

namespace windrow::detail {

/// A unique_ptr whose uses assert that the object was not moved from. After a move only assignment and destruction are legal.
template <class State>
class Owned {
  public:
    Owned(std::unique_ptr<State> state) : state_(std::move(state)) {}

    [[nodiscard]] State* operator->() const {
        assert(state_ != nullptr && "the object was moved from: only assign to it or destroy it");
        return state_.get();
    }
    [[nodiscard]] State& operator*() const { return *operator->(); }
    [[nodiscard]] explicit operator bool() const { return state_ != nullptr; }

  private:
    std::unique_ptr<State> state_;
};

} // namespace windrow::detail
