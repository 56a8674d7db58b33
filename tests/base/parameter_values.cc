// The values of a file, of what it includes from another folder, and of the
// command line reach the objects, the last one wins; numbered sections are
// counted before anything is declared.
#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/parameter_file.h>

#include "../tests.h"

#include <memory>

struct Support : ParameterAcceptor
{
  Support(const unsigned int number)
    : ParameterAcceptor("/Supports/Support " + std::to_string(number))
  {
    add_parameter("Fibers", fibers, "[-]");
    add_parameter("Value", value, "[mm]");
  }

  std::string fibers = "all";
  double      value  = 0.;
};



int
main()
{
  initlog();

  Heddle::create_folder("parts/more");
  Heddle::write_file("parts/one.prm",
                     "subsection Supports\n"
                     "  subsection Support 1\n"
                     "    set Fibers = 0, 1 # the first two\n"
                     "    include more/value.prm\n"
                     "  end\n"
                     "end\n");
  Heddle::write_file("parts/more/value.prm", "set Value = 1.5");
  Heddle::write_file("scene.prm",
                     "include parts/one.prm\n"
                     "subsection Supports\n"
                     "  subsection Support 2\n"
                     "    set Fibers = 3,\\\n"
                     "                 4\n"
                     "    set Value = 7\n"
                     "  end\n"
                     "end\n");

  Heddle::ParameterFile file("scene.prm");
  file.set("Supports/Support 3/Fibers=a = b");
  file.set("Supports/Support 2/Value = 8");

  const unsigned int n_supports = file.count_sections("/Supports", "Support");
  deallog << n_supports << " supports, "
          << file.count_sections("/Supports", "Load") << " loads, "
          << file.count_sections("/", "Support") << " elsewhere" << std::endl;
  deallog << "mentions supports " << file.mentions("/Supports") << ", value 1 "
          << file.mentions("Supports/Support 1/Value") << ", value 3 "
          << file.mentions("Supports/Support 3/Value") << std::endl;

  std::vector<std::unique_ptr<Support>> supports;
  for (unsigned int n = 1; n <= n_supports; ++n)
    supports.push_back(std::make_unique<Support>(n));
  file.apply();
  for (const auto &support : supports)
    deallog << "fibers " << support->fibers << " value " << support->value
            << std::endl;

  file.set("Supports/Support 5/Value=1");
  try
    {
      file.count_sections("Supports", "Support");
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}
