// What: tells temporaries that own their elements from views: an object that keeps a view refuses such a temporary.
#pragma once

#include <concepts>
#include <ranges>
#include <type_traits>

namespace rbpa {

/// A temporary that converts to a view of elements that it owns: the view would outlive the elements.
template <typename T, typename View>
concept TemporaryOwner = !std::is_reference_v<T> && std::convertible_to<T, View> && !std::ranges::borrowed_range<T> &&
                         !std::same_as<std::remove_cv_t<T>, View>;

}  // namespace rbpa
