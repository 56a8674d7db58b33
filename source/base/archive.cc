#include <heddle/base/archive.h>

#include <algorithm>
#include <numeric>

namespace Heddle
{
  void
  Records::reserve(const std::size_t n_rows)
  {
    keys.reserve(n_rows * n_key_parts);
    values.reserve(n_rows * n_values);
  }



  void
  Records::sort()
  {
    const auto before = [this](const std::size_t i, const std::size_t j) {
      return std::lexicographical_compare(
        key(i), key(i) + n_key_parts, key(j), key(j) + n_key_parts);
    };
    std::vector<std::size_t> order(size());
    std::iota(order.begin(), order.end(), 0);
    if (std::is_sorted(order.begin(), order.end(), before))
      return;
    std::stable_sort(order.begin(), order.end(), before);

    Records sorted;
    sorted.n_key_parts = n_key_parts;
    sorted.n_values    = n_values;
    sorted.reserve(order.size());
    for (const auto i : order)
      {
        sorted.keys.insert(sorted.keys.end(), key(i), key(i) + n_key_parts);
        sorted.values.insert(
          sorted.values.end(), value(i), value(i) + n_values);
      }
    keys.swap(sorted.keys);
    values.swap(sorted.values);
  }
} // namespace Heddle
