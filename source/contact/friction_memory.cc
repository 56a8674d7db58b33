#include <heddle/contact/friction_memory.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace Heddle
{
  namespace Contact
  {
    namespace
    {
      /**
       * Part of the distance within which fibers touched over which that fades,
       * on both sides. As wide as the distance itself, bundles that slide with
       * a friction of 0.4 needed 22 steps instead of 10.
       */
      constexpr double edge = 0.1;
    } // namespace



    void
    FrictionMemory::set(std::vector<Record> &new_records)
    {
      records.swap(new_records);
      std::sort(
        records.begin(),
        records.end(),
        [](const Record &left, const Record &right) {
          return std::tie(left.fiber_a, left.fiber_b, left.s_a, left.s_b) <
                 std::tie(right.fiber_a, right.fiber_b, right.s_a, right.s_b);
        });
      longest = 0.;
      for (const Record &record : records)
        longest = std::max(longest, record.weight);
    }



    ArrayView<const FrictionMemory::Record>
    FrictionMemory::between(const unsigned int fiber_a,
                            const unsigned int fiber_b,
                            const double       first,
                            const double       last) const
    {
      const auto begin = std::lower_bound(
        records.begin(),
        records.end(),
        std::tie(fiber_a, fiber_b, first),
        [](const Record &record, const auto &key) {
          return std::tie(record.fiber_a, record.fiber_b, record.s_a) < key;
        });

      // They are few: the end is not worth another search among all.
      const auto end =
        std::find_if(begin, records.end(), [&](const Record &record) {
          return record.fiber_a != fiber_a || record.fiber_b != fiber_b ||
                 record.s_a > last;
        });
      return {records.data() + (begin - records.begin()),
              static_cast<std::size_t>(end - begin)};
    }



    ArrayView<const FrictionMemory::Record>
    FrictionMemory::around(const ContactElement &element,
                           const double          distance) const
    {
      return between(element.fiber_a,
                     element.fiber_b,
                     element.s_a - distance,
                     element.s_a + distance);
    }



    double
    FrictionMemory::limit(const unsigned int fiber_a,
                          const unsigned int fiber_b) const
    {
      const double furthest = std::numeric_limits<double>::max();
      double       sum      = 0.;
      for (const Record &record :
           between(fiber_a, fiber_b, -furthest, furthest))
        sum += record.limit;
      return sum;
    }



    double
    FrictionMemory::touched(const ContactElement &element,
                            const double          reach) const
    {
      double most = 0.;
      for (const Record &record :
           around(element, (1. + edge) * (reach + element.weight + longest)))
        {
          const double apart = std::max(std::abs(record.s_a - element.s_a),
                                        std::abs(record.s_b - element.s_b));
          const double limit = reach + element.weight + record.weight;
          most = std::max(most, 0.5 + 0.5 * (1. - apart / limit) / edge);
        }
      return std::min(most, 1.);
    }



    FrictionMemory::Record
    FrictionMemory::at(const ContactElement &element, const double reach) const
    {
      const auto limit = [&](const double weight) {
        return std::max(reach, 0.75 * (element.weight + weight));
      };
      const double furthest = limit(longest);
      Record       result   = {element.fiber_a,
                               element.fiber_b,
                               element.s_a,
                               element.s_b,
                               element.weight,
                               element.orientation,
                               Tensor<1, 3>(),
                               0.};

      // The nearest record behind and before, along the contact; each fades
      // where it is too far to be of the same contact, so that nothing jumps as
      // particles move.
      const Record *nearest[2]  = {nullptr, nullptr};
      double        distance[2] = {furthest, furthest};
      double        fade[2]     = {0., 0.};
      for (const Record &record : around(element, furthest))
        {
          const double a     = record.s_a - element.s_a,
                       b     = record.s_b - element.s_b;
          const double along = 0.5 * (a + record.orientation * b),
                       apart = std::max(std::abs(a), std::abs(b));
          const bool side    = along > 0.;
          if (apart < limit(record.weight) && std::abs(along) < distance[side])
            {
              nearest[side]  = &record;
              distance[side] = std::abs(along);
              fade[side] =
                std::clamp(2. - 2. * apart / limit(record.weight), 0., 1.);
            }
        }

      // Near a right angle two neighbours may have their frames turned: the
      // nearer one counts.
      const unsigned int one = distance[1] < distance[0];
      if (nearest[one] == nullptr)
        return result;
      result.orientation = nearest[one]->orientation;
      if (nearest[1 - one] != nullptr &&
          nearest[1 - one]->orientation != result.orientation)
        fade[1 - one] = 0.;

      // Between the two it changes linearly.
      const double first  = fade[0] * distance[1],
                   second = fade[1] * distance[0];
      const double part =
        first + second > 0. ? second / (first + second) : double(one);
      for (unsigned int side = 0; side < 2; ++side)
        if (nearest[side] != nullptr)
          {
            const Record &record = *nearest[side];
            const double  share =
              std::max(fade[0], fade[1]) * (side == 1 ? part : 1. - part);
            result.displacement += share * record.displacement;
            result.limit +=
              share * record.limit * element.weight / record.weight;
          }
      return result;
    }



    void
    FrictionMemory::save(ArchiveWriter                           &archive,
                         const std::string                       &name,
                         const std::function<bool(unsigned int)> &owned) const
    {
      // Records of one pair are told apart by their number.
      Records rows;
      rows.n_key_parts = 3;
      rows.n_values    = 8;
      rows.reserve(records.size());
      unsigned int number = 0;
      for (std::size_t i = 0; i < records.size(); ++i)
        {
          const Record &record = records[i];
          number = i > 0 && records[i - 1].fiber_a == record.fiber_a &&
                       records[i - 1].fiber_b == record.fiber_b
                     ? number + 1
                     : 0;
          if (!owned(record.fiber_a))
            continue;
          rows.keys.insert(rows.keys.end(),
                           {record.fiber_a, record.fiber_b, number});
          rows.values.insert(rows.values.end(),
                             {record.s_a,
                              record.s_b,
                              record.weight,
                              double(record.orientation),
                              record.displacement[0],
                              record.displacement[1],
                              record.displacement[2],
                              record.limit});
        }
      archive.write(name, std::move(rows));
    }



    void
    FrictionMemory::load(const ArchiveReader                     &archive,
                         const std::string                       &name,
                         const std::function<bool(unsigned int)> &wanted)
    {
      const Records rows =
        archive.read_records(name, [&wanted](const std::int64_t *key) {
          return wanted(key[0]) || wanted(key[1]);
        });
      std::vector<Record> loaded;
      for (std::size_t i = 0; i < rows.size(); ++i)
        {
          const double *value = rows.value(i);
          loaded.push_back({static_cast<unsigned int>(rows.key(i)[0]),
                            static_cast<unsigned int>(rows.key(i)[1]),
                            value[0],
                            value[1],
                            value[2],
                            value[3] > 0. ? 1 : -1,
                            Tensor<1, 3>({value[4], value[5], value[6]}),
                            value[7]});
        }
      set(loaded);
    }
  } // namespace Contact
} // namespace Heddle
