#ifndef heddle_base_lanes_h
#define heddle_base_lanes_h

namespace Heddle
{
  namespace internal
  {
    template <unsigned int n>
    struct Register
    {
      typedef double Lanes __attribute__((vector_size(8 * n)));
    };
  } // namespace internal



  /**
   * n numbers, a power of two, side by side in registers, with which operators
   * compute at once: a vector of GCC and Clang. Of loops over arrays the
   * compiler leaves most to one number after the other, and classes take ten
   * times as long in Debug. A tensor of rank one is kept as its three
   * components and a zero.
   *
   * Functions take and return them by reference only: where processors have no
   * such registers, by value would be another convention.
   */
  template <unsigned int n>
  using Lanes = typename internal::Register<n>::Lanes;
} // namespace Heddle

#endif
