// A table is written with units in its head and ten digits, leaves what was
// not set empty, and is read back as it was.
#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/table.h>

#include "../tests.h"

int
main()
{
  initlog();

  Heddle::StepTable table;
  table.add_column("load_factor", "-");
  table.add_column("force_x", "N");
  table.add_column("contacts", "-");
  for (unsigned int step = 1; step <= 3; ++step)
    {
      table.begin_row();
      table.set("load_factor", step / 3.);
      if (step != 2)
        table.set("force_x", -1e-7 * step);
      table.set("contacts", 123456789 * step);
    }
  table.write("history.csv");
  const std::string csv = Heddle::read_file("history.csv", "table");
  deallog << csv << std::endl;

  Heddle::StepTable other;
  other.add_column("load_factor", "-");
  other.add_column("force_x", "N");
  other.add_column("contacts", "-");
  other.read(csv);
  deallog << "same: " << (other.csv() == csv)
          << ", unset: " << std::isnan(other.get(1, "force_x")) << std::endl;

  // Another column, one that is not there, one too many.
  for (const std::vector<std::string> &names :
       {std::vector<std::string>{"strain"},
        {"load_factor", "force_x", "contacts", "work"},
        {"load_factor"}})
    {
      other = {};
      for (const std::string &name : names)
        other.add_column(name, name == "force_x" ? "N" : "-");
      try
        {
          other.read(csv);
        }
      catch (const Heddle::InputError &error)
        {
          deallog << error.what() << std::endl;
        }
    }
}
