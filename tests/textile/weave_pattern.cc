// Every weave has the pattern of its textbook, and repeats itself.
#include <heddle/textile/weave_pattern.h>

#include "../tests.h"

#include <utility>

int
main()
{
  initlog();
  for (const std::string name : {"plain",
                                 "twill 2/2",
                                 "twill 3/1",
                                 "satin 5/2",
                                 "satin 8/3",
                                 "basket 2/2",
                                 "basket 2/1",
                                 "0 1; 1 1; 1 0"})
    {
      const Heddle::Textile::WeavePattern pattern(name);
      deallog << name << " repeats after " << pattern.n_warp() << " warp and "
              << pattern.n_weft() << " weft yarns" << std::endl;
      for (unsigned int j = 0; j < pattern.n_weft() + 1; ++j)
        {
          std::string row;
          for (unsigned int i = 0; i < pattern.n_warp() + 2; ++i)
            row += pattern.warp_on_top(i, j) ? '1' : '0';
          deallog << "  " << row << std::endl;
        }
    }

  // Names without numbers.
  for (const auto &names : std::vector<std::pair<std::string, std::string>>{
         {"twill", "twill 2/2"},
         {"satin", "satin 5/2"},
         {"basket", "basket 2/2"}})
    {
      const Heddle::Textile::WeavePattern bare(names.first), full(names.second);
      bool                                same =
        bare.n_warp() == full.n_warp() && bare.n_weft() == full.n_weft();
      for (unsigned int i = 0; i < full.n_warp(); ++i)
        for (unsigned int j = 0; j < full.n_weft(); ++j)
          same = same && bare.warp_on_top(i, j) == full.warp_on_top(i, j);
      deallog << names.first << " is " << names.second << ": " << same
              << std::endl;
    }
}
