#include <heddle/base/choice.h>
#include <heddle/base/exceptions.h>
#include <heddle/base/number_text.h>
#include <heddle/base/turning_points.h>
#include <heddle/simulation/fabric_loading_parameters.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      const std::string fabric_loading = "Fabric loading: ";



      /** The least and the largest value of @p ramp. */
      std::array<double, 2>
      range_of(const Expression &ramp)
      {
        std::array<double, 2> range = {};
        const auto            add   = [&](const double load_factor) {
          const double value = ramp.value(Tensor<1, 3>(), load_factor);
          range = {{std::min(range[0], value), std::max(range[1], value)}};
        };
        for (unsigned int i = 1; i <= 100; ++i)
          add(0.01 * i);
        for (const double load_factor : Heddle::turning_points(ramp))
          add(load_factor);
        return range;
      }



      /** Whether a fabric may be stretched by @p strain. */
      bool
      is_possible(const double strain)
      {
        return strain > -1. && strain < 10.;
      }
    } // namespace



    FabricLoadingParameters::FabricLoadingParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      add_choice(*this,
                 "Kind",
                 kind,
                 "Test of a fabric, whose four sides are moved: the ends of "
                 "its fibers and, if it has one, the sides of its matrix. "
                 "Where it is pulled in both directions or, dry, sheared the "
                 "ends of each yarn move as one body. "
                 "Every load case begins in the initial configuration, "
                 "with the tension under which it was computed, unless "
                 "'Restart/Stress free' is true. What the case lets go of, "
                 "as two sides in uniaxial tension, gives way before it is "
                 "loaded, and the tension with it: forces at load factor 0 "
                 "are what is left, and may push. 'bending': to a cylinder. "
                 "'held': the sides stay where "
                 "they are, as for compression by 'Plates'. "
                 "'none': supports and loads as listed, if any. No other "
                 "entry is active then [-].");
      add_parameter("Strain",
                    strain,
                    "Engineering strain, where the ramp is 1, of the warp or, "
                    "in uniaxial tension, of the direction in which it is "
                    "pulled. Inactive in other tests [-].");
      add_parameter(
        "Strain ratios",
        strain_ratios,
        "Strain of the warp over that of the weft, above 0, one "
        "load case each, as in '1, 2, 4'. Inactive unless 'Kind' is "
        "'biaxial tension' [-].",
        prm,
        Patterns::List(Patterns::Double(), 1));
      add_choice(*this,
                 "Direction",
                 direction,
                 "Which yarns are pulled, and their ends keep their places "
                 "across, or which are bent. Inactive unless 'Kind' is "
                 "'uniaxial tension' or 'bending' [-].");
      add_choice(*this,
                 "Sides",
                 sides,
                 "What the two other sides do: 'held' keeps their distance, "
                 "while the yarns that end there may slide along the pull, "
                 "'free' leaves them free in the plane, for which there "
                 "must be friction or a matrix. Both keep their height. In "
                 "bending they follow the cylinder, and 'free' leaves them "
                 "free across. "
                 "Inactive unless 'Kind' is 'uniaxial tension' or 'bending' "
                 "[-].");
      add_parameter("Shear angles",
                    shear_angles,
                    "By how much the angle between warp and weft gets smaller, "
                    "where the ramp is 1, one load case each, as in '20, -20'. "
                    "Inactive unless 'Kind' is 'picture frame' or 'simple "
                    "shear' [degrees].",
                    prm,
                    Patterns::List(Patterns::Double(), 1));
      add_choice(*this,
                 "Yarn ends",
                 yarn_ends,
                 "What the ends of fibers do in a matrix that is sheared. "
                 "'embedded': along their yarn they move as the sides do; "
                 "across it, in the plane, nothing holds them but matrix and "
                 "contact; 'gripped': the ends of each yarn turn as one "
                 "body, as in a dry fabric, and drag their fibers through "
                 "the matrix. Inactive unless 'Kind' is 'picture frame' or "
                 "'simple shear', and without a matrix [-].");
      add_parameter("Curvature",
                    curvature,
                    "To which the fabric is bent where the ramp is 1, upwards "
                    "at its ends if it is positive. What keeps its length is "
                    "the mean height of the yarns that are bent, by their "
                    "axial stiffness. Inactive unless 'Kind' is 'bending' "
                    "[1/mm].");
      add_choice(*this,
                 "Grip",
                 grip,
                 "'one side': fibers that are bent may slide along themselves "
                 "at their last ends, as in a strip of which one end is free, "
                 "so that yarns are as soft as their fibers let them be; "
                 "'both sides': they are gripped at both ends, as by the "
                 "clamps of a machine, and then those that lie higher in a "
                 "yarn become shorter and resist, however long it is. "
                 "Inactive unless 'Kind' is 'bending', and with a matrix, "
                 "which grips them [-].");
      add_choice(*this,
                 "Ends",
                 ends,
                 "'hinged': sections at the ends of fibers are free to "
                 "turn; 'clamped': they turn as the fabric shears along "
                 "their yarns, or not at all where nothing turns. Sides "
                 "that are free have free sections. Inactive in bending, "
                 "where yarns that are bent are clamped, and no others [-].");
      add_parameter("Ramp",
                    ramp,
                    "Formula of the load factor t by which strains, angles and "
                    "the curvature are multiplied, 0 at t = 0, for instance "
                    "'1 - abs(2*t - 1)' to load and unload. Where it turns "
                    "back there is a load step [-].");
      parse_parameters_call_back.connect([this]() { check(); });
    }



    std::string
    FabricLoadingParameters::strain_in_percent() const
    {
      // More than fabrics of other fibers than rubber bear.
      constexpr double largest_strain = 0.5;
      if (!(pulls(YarnSet::warp) || pulls(YarnSet::weft)) ||
          std::abs(strain) <= largest_strain)
        return "";
      return fabric_loading + "\"Strain\" is " + number_text(strain) +
             ", which is " + number_text(100. * strain) +
             " %: a strain is a change of length over length";
    }



    void
    FabricLoadingParameters::check() const
    {
      if (!is_active() || kind == FabricTest::held)
        return;
      const Expression formula(ramp, fabric_loading + "\"Ramp\"");
      require(std::abs(formula.value(Tensor<1, 3>(), 0.)) < 1e-12,
              fabric_loading + "\"Ramp\" is \"" + ramp + "\", which is " +
                number_text(formula.value(Tensor<1, 3>(), 0.)) +
                " at t = 0; let it begin at 0.");
      for (const double t : {0.3, 0.7, 1.})
        require(formula.value(Tensor<1, 3>(), t) ==
                  formula.value(Tensor<1, 3>({0.1, 0.2, 0.3}), t),
                fabric_loading + "\"Ramp\" is \"" + ramp +
                  "\", which is not the same everywhere; let it depend on t "
                  "alone.");
      const auto range = range_of(formula);
      require(range[0] != range[1],
              fabric_loading + "\"Ramp\" is \"" + ramp +
                "\", which is 0 from t = 0 to 1, and loads nothing; let it "
                "depend on t, or set \"Kind\" to \"held\".");
      const bool stretches = pulls(YarnSet::warp) || pulls(YarnSet::weft);
      require(!stretches || strain != 0.,
              fabric_loading +
                "\"Strain\" is 0, and pulls nothing; 0.02 are 2 %, and where "
                "nothing is to be pulled \"Kind\" is \"held\".");
      require(!stretches || is_possible(strain),
              fabric_loading + "\"Strain\" is " + number_text(strain) +
                "; it must lie between -1 and 10, and 0.02 are 2 %.");
      require(!bends() || (std::isfinite(curvature) && curvature != 0.),
              fabric_loading + "\"Curvature\" is " + number_text(curvature) +
                "; a curvature is not 0, and 0.5 is that of a radius of 2 mm.");
      const std::string entry = is_shear() ? "Shear angles" : "Strain ratios";
      const auto        all   = numbers();
      for (auto number = all.begin(); number != all.end(); ++number)
        {
          require(is_shear() || *number > 0.,
                  fabric_loading + "\"Strain ratios\" names " +
                    number_text(*number) +
                    "; the strain of the warp over that of the weft must be "
                    "positive.");
          require(!stretches || is_possible(strain / *number),
                  fabric_loading + "\"Strain ratios\" names " +
                    number_text(*number) +
                    ", which makes the strain of the weft " +
                    number_text(strain / *number, 6) +
                    "; it must lie between -1 and 10.");
          require(!is_shear() || (*number != 0. && std::abs(*number) < 90.),
                  fabric_loading + "\"Shear angles\" names " +
                    number_text(*number) +
                    "; a shear angle is not 0 and lies between -90 and 90 "
                    "degrees.");
          require(std::none_of(all.begin(),
                               number,
                               [&](const double other) {
                                 return name(other) == name(*number);
                               }),
                  fabric_loading + '"' + entry + "\" names " +
                    number_text(*number) +
                    " twice; each load case is computed once.");
        }
      for (const double reached : range)
        check_where_ramp_is(reached);
    }



    void
    FabricLoadingParameters::check_where_ramp_is(const double reached) const
    {
      const auto where = [&](const double value) {
        return fabric_loading + "\"Ramp\" is \"" + ramp +
               "\", which comes to " + number_text(reached, 6) + " and makes " +
               number_text(value, 6);
      };
      const bool stretches = pulls(YarnSet::warp) || pulls(YarnSet::weft);
      for (const double number : numbers())
        {
          require(!is_shear() || std::abs(reached * number) < 90.,
                  where(reached * number) + " degrees of a shear angle of " +
                    number_text(number) + "; it must stay between -90 and 90.");
          for (const double of_yarns : {strain, strain / number})
            require(!stretches || is_possible(reached * of_yarns),
                    where(reached * of_yarns) + " of a strain of " +
                      number_text(of_yarns, 6) +
                      "; it must stay between -1 and 10.");
        }
    }



    double
    FabricLoadingParameters::largest_ramp() const
    {
      const auto range =
        range_of(Expression(ramp, fabric_loading + "\"Ramp\""));
      return std::max(-range[0], range[1]);
    }



    double
    FabricLoadingParameters::largest_curvature() const
    {
      return bends() ? std::abs(curvature) * largest_ramp() : 0.;
    }



    double
    FabricLoadingParameters::largest_shear_angle() const
    {
      double largest = 0.;
      if (is_shear())
        for (const double angle : shear_angles)
          largest = std::max(largest, std::abs(angle));
      return largest > 0. ? largest * largest_ramp() : 0.;
    }



    bool
    FabricLoadingParameters::pulls(const YarnSet yarns) const
    {
      return kind == FabricTest::biaxial_tension ||
             (kind == FabricTest::uniaxial_tension && direction == yarns);
    }



    std::vector<double>
    FabricLoadingParameters::turning_points() const
    {
      if (kind == FabricTest::held)
        return {};
      return Heddle::turning_points(
        Expression(ramp, fabric_loading + "\"Ramp\""));
    }



    std::vector<double>
    FabricLoadingParameters::numbers() const
    {
      switch (kind)
        {
          case FabricTest::biaxial_tension:
            return strain_ratios;
          case FabricTest::picture_frame:
          case FabricTest::simple_shear:
            return shear_angles;
          case FabricTest::none:
          case FabricTest::held:
          case FabricTest::bending:
          case FabricTest::uniaxial_tension:
            break;
        }
      return {1.};
    }



    std::string
    FabricLoadingParameters::name(const double number) const
    {
      const std::string value = " " + number_text(number, 6);
      switch (kind)
        {
          case FabricTest::biaxial_tension:
            return "biaxial" + value;
          case FabricTest::uniaxial_tension:
            return std::string("uniaxial ") + word(direction);
          case FabricTest::bending:
            return std::string("bending ") + word(direction);
          case FabricTest::picture_frame:
          case FabricTest::simple_shear:
            return word(kind) + value;
          case FabricTest::held:
            return word(kind);
          case FabricTest::none:
            break;
        }
      return "";
    }



    Contributions::FabricMotion
    FabricLoadingParameters::motion(const double number) const
    {
      using Motion = Contributions::FabricMotion;
      if (is_shear())
        return Motion({{0., 0.}},
                      number * dealii::numbers::PI / 180.,
                      kind == FabricTest::simple_shear
                        ? Motion::Shear::simple
                        : Motion::Shear::picture_frame,
                      ramp);
      Motion::Both<double> strains = {{strain, strain / number}};
      if (kind == FabricTest::held || bends())
        strains = {{0., 0.}};
      if (kind == FabricTest::uniaxial_tension)
        strains[direction == YarnSet::warp ? 1 : 0] = 0.;
      return Motion(strains, 0., Motion::Shear::picture_frame, ramp);
    }



    Contributions::SupportList
    FabricLoadingParameters::supports(const Contributions::FabricMotion &motion,
                                      const FibersAtSides               &fibers,
                                      const bool matrix) const
    {
      const auto displacements = motion.displacements();
      const auto angles        = motion.turn_angles();
      const bool uniaxial      = kind == FabricTest::uniaxial_tension;
      Contributions::SupportList list;
      for (const YarnSet family : all_choices<YarnSet>())
        for (const bool upper : {false, true})
          {
            const auto along      = static_cast<unsigned int>(family);
            const bool lateral    = uniaxial && family != direction;
            auto       support    = std::make_shared<Contributions::Support>();
            support->where        = "Fabric loading";
            support->nodes.fibers = fibers[list.size()];
            support->nodes.nodes  = upper
                                      ? Contributions::ChosenNodes::last_end
                                      : Contributions::ChosenNodes::first_end;
            if (matrix)
              support->matrix_sides = {
                static_cast<Contributions::MatrixSide>(2 * along + upper)};
            support->displacement = {{displacements[0], displacements[1], "0"}};
            if (lateral)
              {
                support->displacement[1 - along] = "free";
                if (sides == FreeSides::free)
                  support->displacement[along] = "free";
              }
            support->angle = angles[along];
            if (is_shear() && matrix && yarn_ends == YarnEnds::embedded)
              support->slides_along = 1 - along;
            else
              // Fibers that touch cannot come nearer: yarns do not shear, nor
              // get narrower, as a matrix does.
              support->yarns_are_bodies =
                is_shear() || bends() || kind == FabricTest::biaxial_tension;
            if (bends())
              bend(family == direction,
                   upper && grip == Grip::one_side && !matrix,
                   *support);
            else if (ends == SideSections::clamped &&
                     !(lateral && leaves_yarns_free()))
              {
                support->section = is_shear()
                                     ? Contributions::SupportedSection::turned
                                     : Contributions::SupportedSection::held;
              }
            list.push_back(support);
          }
      return list;
    }



    Contributions::FabricBending
    FabricLoadingParameters::bending() const
    {
      return {static_cast<unsigned int>(direction), curvature, ramp};
    }



    void
    FabricLoadingParameters::bend(const bool              bent,
                                  const bool              slides,
                                  Contributions::Support &support) const
    {
      const Contributions::FabricBending cylinder = bending();
      support.displacement                        = cylinder.displacement();
      support.angle                               = cylinder.turn_angle();
      support.axis                                = cylinder.axis();
      if (bent)
        {
          support.section = Contributions::SupportedSection::turned;
          if (slides)
            support.slides_along = cylinder.direction();
        }
      else if (sides == FreeSides::free)
        support.displacement[1 - cylinder.direction()] = "free";
    }



    std::vector<Contributions::FabricCase>
    FabricLoadingParameters::cases(const FibersAtSides &fibers,
                                   const bool           matrix) const
    {
      std::vector<Contributions::FabricCase> list;
      if (is_active())
        for (const double number : numbers())
          {
            const Contributions::FabricMotion moved = motion(number);
            list.push_back(
              {name(number),
               supports(moved, fibers, matrix),
               moved,
               {{pulls(YarnSet::warp), pulls(YarnSet::weft)}},
               bends() ? std::make_optional(bending()) : std::nullopt});
          }
      return list;
    }
  } // namespace Simulation
} // namespace Heddle
