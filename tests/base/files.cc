// Files, folders and tables are written as a whole and read back as they were;
// what cannot be is told in a sentence.
#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/table.h>

#include "../tests.h"

#include <filesystem>
#include <functional>

void
answer(const std::function<void()> &action)
{
  try
    {
      action();
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



/**
 * Files are replaced as a whole and folders are created with those above; what
 * cannot be read or created is told in a sentence.
 */
void
files_and_folders()
{
  Heddle::create_folder("a/b");
  Heddle::create_folder("a/b");
  Heddle::write_file("a/b/text", "first");
  Heddle::write_file("a/b/text", "second\n");
  deallog << Heddle::read_file("a/b/text", "text")
          << "left over: " << std::filesystem::exists("a/b/text.new")
          << std::endl;

  Heddle::write_file("a/marked", "\xEF\xBB\xBFof a spreadsheet");
  deallog << Heddle::read_file("a/marked", "text") << std::endl;

  answer([]() { Heddle::read_file("a/none", "list of points"); });
  answer([]() { Heddle::read_file("a", "list of points"); });
  answer([]() { Heddle::create_folder("a/b/text/c"); });

  deallog << Heddle::relative_to("a/b.prm", "c.prm") << ' '
          << Heddle::relative_to("a/b.prm", "../c.prm") << ' '
          << Heddle::relative_to("b.prm", "c.prm") << ' '
          << Heddle::relative_to("a/b.prm", "/c.prm") << std::endl;
}



/**
 * A table is written with units in its head and ten digits, leaves what was not
 * set empty, and is read back as it was.
 */
void
tables()
{
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



int
main()
{
  initlog();
  run_part("Files and folders", files_and_folders);
  run_part("Tables", tables);
}
