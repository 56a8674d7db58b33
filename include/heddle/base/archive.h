#ifndef heddle_base_archive_h
#define heddle_base_archive_h

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace Heddle
{
  /**
   * Records that are found by a key of integers, for instance the history of a
   * contact by the two fibers and the cell along them. Row i of the keys
   * belongs to row i of the values.
   */
  struct Records
  {
    unsigned int              n_key_parts = 1;
    unsigned int              n_values    = 1;
    std::vector<std::int64_t> keys;
    std::vector<double>       values;

    std::size_t
    size() const
    {
      return keys.size() / n_key_parts;
    }

    const std::int64_t *
    key(const std::size_t i) const
    {
      return keys.data() + i * n_key_parts;
    }

    const double *
    value(const std::size_t i) const
    {
      return values.data() + i * n_values;
    }

    /** Have room for so many rows of the parts and values that they have. */
    void
    reserve(const std::size_t n_rows);

    /** Bring the rows into the lexicographic order of their keys. */
    void
    sort();
  };

  /**
   * Where the parts of a program put what a checkpoint must keep. Everything is
   * named, "part/what", and numbered by global ids, never by ranks: what one
   * number of ranks wrote, any other number reads.
   *
   * @note All functions are collective.
   */
  class ArchiveWriter
  {
  public:
    virtual ~ArchiveWriter() = default;

    /**
     * Write this rank's rows of a table of @p n_rows rows over all ranks, each
     * of @p n_columns numbers. Its rows begin with row @p first_row; every row
     * is written by one rank.
     */
    virtual void
    write(const std::string         &name,
          const std::uint64_t        first_row,
          const std::uint64_t        n_rows,
          const std::vector<double> &values,
          const unsigned int         n_columns = 1) = 0;

    /**
     * Write the records of all ranks; each record is given by one rank. Those
     * that are moved here are not copied.
     */
    virtual void
    write(const std::string &name, Records records) = 0;

    /** Write a number or a text that is the same on all ranks. */
    virtual void
    write_number(const std::string &name, const double value) = 0;
    virtual void
    write_text(const std::string &name, const std::string &text) = 0;
  };

  /**
   * The counterpart of ArchiveWriter. A name that is not there, or a table of
   * another size than expected, is an error of one sentence.
   *
   * @note All functions are collective.
   */
  class ArchiveReader
  {
  public:
    virtual ~ArchiveReader() = default;

    /** Whether something of this name was written. */
    virtual bool
    has(const std::string &name) const = 0;

    /** Return the number of rows of a table over all ranks. */
    virtual std::uint64_t
    n_rows(const std::string &name) const = 0;

    /** Return @p n_rows rows of a table, beginning with @p first_row. */
    virtual std::vector<double>
    read(const std::string  &name,
         const std::uint64_t first_row,
         const std::uint64_t n_rows,
         const unsigned int  n_columns = 1) const = 0;

    /** Return the records whose key is wanted on this rank, sorted by key. */
    virtual Records
    read_records(
      const std::string                               &name,
      const std::function<bool(const std::int64_t *)> &wanted) const = 0;

    virtual double
    read_number(const std::string &name) const = 0;
    virtual std::string
    read_text(const std::string &name) const = 0;
  };
} // namespace Heddle

#endif
