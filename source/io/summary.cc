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



        std::string
        name(const Heddle::IO::Summary::Status status)
        {
          using Status = Heddle::IO::Summary::Status;
          switch (status)
            {
              case Status::running:
                return "running";
              case Status::converged:
                return "converged";
              case Status::not_converged:
                return "not converged";
              case Status::stopped:
                return "stopped";
              case Status::failed:
                break;
            }
          return "failed";
        }



        Json
        to_json(const StageSummary &stage)
        {
          Json json;
          json["name"]                    = stage.name;
          json["status"]                  = stage.status;
          json["steps"]                   = stage.steps;
          json["newton_iterations"]       = stage.newton_iterations;
          json["factorizations"]          = stage.factorizations;
          json["linear_iterations"]       = stage.linear_iterations;
          json["contact_elements"]        = stage.contact_elements;
          json["active_contact_elements"] = stage.active_contact_elements;
          json["n_dofs_per_rank"]         = stage.n_dofs_per_rank;
          json["max_penetration_ratio"]   = stage.max_penetration_ratio;
          json["max_indentation_ratio"]   = stage.max_indentation_ratio;
          json["indentation_work_ratio"]  = stage.indentation_work_ratio;
          json["max_bend_ratio"]          = stage.max_bend_ratio;
          json["crossings_total"]         = stage.crossings_total;
          json["crossings_wrong"]         = stage.crossings_wrong;
          json["crossings_apart"]         = stage.crossings_apart;
          json["residual_ratio"]          = stage.residual_ratio;
          json["last_output"]             = stage.last_output;
          json["wall_time_s"]             = {
                        {"total", stage.wall_time.total},
                        {"detection", stage.wall_time.detection},
                        {"assembly", stage.wall_time.assembly},
                        {"linear_solver", stage.wall_time.linear_solver},
                        {"line_search", stage.wall_time.line_search},
                        {"output", stage.wall_time.output}};
          return json;
        }



        void
        add(const MatrixSummary &matrix, Json &json)
        {
          json["n_matrix_cells"]      = matrix.n_cells;
          json["n_matrix_nodes"]      = matrix.n_nodes;
          json["n_links"]             = matrix.n_links;
          json["n_matrix_assemblies"] = matrix.n_assemblies;
          json["matrix_volume_mm3"]   = matrix.volume;
          json["doubled_volume_mm3"]  = matrix.doubled_volume;
          json["doubled_part"]        = matrix.doubled_volume / matrix.volume;
        }
      } // namespace Summary
    }   // namespace internal



    std::string
    Summary::json() const
    {
      internal::Summary::Json json;
      json["status"] = internal::Summary::name(status);
      json["reason"] = reason;

      json["n_fibers"]      = n_fibers;
      json["n_fiber_nodes"] = n_fiber_nodes;
      json["n_dofs"]        = n_dofs;
      json["ranks"]         = ranks;
      json["contributions"] = contributions;
      if (matrix)
        internal::Summary::add(*matrix, json);

      json["stages"] = internal::Summary::Json::array();
      for (const auto &stage : stages)
        json["stages"].push_back(internal::Summary::to_json(stage));

      json["results"]  = results;
      json["versions"] = versions;
      return json.dump(2) + "\n";
    }



    void
    Summary::write(const std::string &directory) const
    {
      write_file(directory + "/summary.json", json());
    }
  } // namespace IO
} // namespace Heddle
