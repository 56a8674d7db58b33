// Files are replaced as a whole and folders are created with those above;
// what cannot be read or created is told in a sentence.
#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>

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



int
main()
{
  initlog();
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
