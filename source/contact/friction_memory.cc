#include <heddle/contact/friction_memory.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace Heddle
{
  namespace Contact
  {
    namespace
    {
      auto
      order(const FrictionMemory::Record &record)
      {
        return std::make_tuple(
          record.fiber_a, record.fiber_b, record.s_a, record.s_b);
      }



      bool
      earlier(const FrictionMemory::Record &left,
              const FrictionMemory::Record &right)
      {
        return order(left) < order(right);
      }
    } // namespace



    void
    FrictionMemory::set(std::vector<Record> &new_records)
    {
      records.swap(new_records);
      std::sort(records.begin(), records.end(), earlier);
      longest = 0.;
      for (const Record &record : records)
        longest = std::max(longest, record.weight);
    }



    double
    FrictionMemory::limit(const unsigned int fiber_a,
                          const unsigned int fiber_b) const
    {
      const double lowest = -std::numeric_limits<double>::max();
      const Record first  = {
         fiber_a, fiber_b, lowest, lowest, 0., 1, Tensor<1, 3>(), 0.};
      double sum = 0.;
      for (auto record =
             std::lower_bound(records.begin(), records.end(), first, earlier);
           record != records.end() && record->fiber_a == fiber_a &&
           record->fiber_b == fiber_b;
           ++record)
        sum += record->limit;
      return sum;
    }



    FrictionMemory::Record
    FrictionMemory::at(const ContactElement &element, const double reach) const
    {
      const double furthest = std::max(reach, 2. * longest);
      Record       none     = {element.fiber_a,
                               element.fiber_b,
                               element.s_a - furthest,
                               -std::numeric_limits<double>::max(),
                               0.,
                               element.orientation,
                               Tensor<1, 3>(),
                               0.};

      // The nearest record behind and before, along the contact.
      const Record *nearest[2]  = {nullptr, nullptr};
      double        distance[2] = {furthest, furthest};
      for (auto record =
             std::lower_bound(records.begin(), records.end(), none, earlier);
           record != records.end() && record->fiber_a == element.fiber_a &&
           record->fiber_b == element.fiber_b &&
           record->s_a <= element.s_a + furthest;
           ++record)
        {
          const double along_a = record->s_a - element.s_a,
                       along_b = record->s_b - element.s_b;
          // Along the contact as the record saw it: close to a right angle what
          // is along for one of two is across for the other.
          const double along  = 0.5 * (along_a + record->orientation * along_b);
          const bool   before = along > 0.;
          if (std::max(std::abs(along_a), std::abs(along_b)) < furthest &&
              std::abs(along) < distance[before])
            {
              nearest[before]  = &*record;
              distance[before] = std::abs(along);
            }
        }

      const Record *one = nearest[distance[1] < distance[0]];
      if (one == nullptr)
        return none;
      // Near a right angle two neighbours may have their frames turned.
      const double sum = distance[0] + distance[1];
      if (nearest[0] == nullptr || nearest[1] == nullptr ||
          sum > nearest[0]->weight + nearest[1]->weight ||
          nearest[0]->orientation != nearest[1]->orientation)
        return *one;
      const double part   = sum > 0. ? distance[0] / sum : 0.;
      Record       result = *nearest[0];
      result.displacement +=
        part * (nearest[1]->displacement - nearest[0]->displacement);
      return result;
    }



    void
    FrictionMemory::save(ArchiveWriter                           &archive,
                         const std::string                       &name,
                         const std::function<bool(unsigned int)> &owned) const
    {
      // Records of one pair are told apart by their number.
      Records rows;
      rows.n_key_parts    = 3;
      rows.n_values       = 8;
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
      archive.write(name, rows);
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
