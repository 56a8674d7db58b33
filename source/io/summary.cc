#include <heddle/base/file.h>
#include <heddle/io/summary.h>

#include <nlohmann/json.hpp>

namespace Heddle
{
  namespace IO
  {
    namespace internal
    {
      namespace Summary
      {
        /** Keeps the order in which the entries are set. */
        using Json = nlohmann::ordered_json;



        template <typename Value>
        const Value &
        to_json(const Value &value)
        {
          return value;
        }



        std::string
        to_json(const Status &status)
        {
          return word(status);
        }



        Json
        to_json(const WallTime &time)
        {
          Json json;
          WallTime::describe(
            [&json](const std::string &name, const double seconds) {
              json[name] = seconds;
            },
            time);
          return json;
        }



        Json
        to_json(const StageSummary &stage)
        {
          Json json;
          StageSummary::describe(
            [&json](const std::string &name, const auto &value) {
              json[name] = to_json(value);
            },
            stage);
          return json;
        }
      } // namespace Summary
    }   // namespace internal



    std::string
    Summary::json() const
    {
      internal::Summary::Json json;
      json["status"] = word(status);
      json["reason"] = reason;

      json["n_fibers"]      = n_fibers;
      json["n_fiber_nodes"] = n_fiber_nodes;
      json["n_dofs"]        = n_dofs;
      json["ranks"]         = ranks;
      json["contributions"] = contributions;
      if (matrix)
        MatrixSummary::describe(
          [&json](const std::string &name, const auto &value) {
            json[name] = value;
          },
          *matrix);

      json["stages"] = internal::Summary::Json::array();
      for (const auto &stage : stages)
        json["stages"].push_back(internal::Summary::to_json(stage));

      json["results"]  = results;
      json["versions"] = versions;
      // Names of folders, which a reason may tell, are in any encoding.
      constexpr auto replace =
        internal::Summary::Json::error_handler_t::replace;
      return json.dump(2, ' ', false, replace) + "\n";
    }



    void
    Summary::write(const std::string &directory) const
    {
      write_file(directory + "/summary.json", json());
    }
  } // namespace IO
} // namespace Heddle
