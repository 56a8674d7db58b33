#include <heddle/base/archive.h>

#include <algorithm>
#include <numeric>

namespace Heddle
{
  void
  Records::sort()
  {
    std::vector<std::size_t> order(size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(
      order.begin(),
      order.end(),
      [this](const std::size_t i, const std::size_t j) {
        return std::lexicographical_compare(
          key(i), key(i) + n_key_parts, key(j), key(j) + n_key_parts);
      });

    Records sorted;
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
