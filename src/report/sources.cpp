#include "report/sources.hpp"

namespace facet::report {

namespace {

// Every table has a row; empty: what facet does of its own, or pictures as a whole.
constexpr optics::Sources sources[] = {
    // report fresnel, diffuse, ndf
    {"fresnel-dielectric", "Schlick1994 Cook1982 Kulla2017"},
    {"fresnel-metal", "Schlick1994 Kutz2021 Johnson1972 Johnson1974 Rakic1995 Rakic1998 Querry1985"},
    {"diffuse", "Burley2012 Lagarde2014 Oren1994 Portsmouth2024 Chan2018"},
    {"masking", "Heitz2014 Schlick1994 Walter2007"},
    {"lobes", "Walter2007 Blinn1977 Heitz2014 Schlick1994 Cook1982"},
    // report energy
    {"energy-furnace", "FdezAguera2019 Kulla2017 Hill2018 Turquin2019"},
    {"energy-metal", "FdezAguera2019 Kulla2017 Hill2018 Turquin2019 Heitz2016"},
    {"energy-pictures", "FdezAguera2019 Kulla2017 Hill2018 Turquin2019"},
    // report light
    {"light-cube", ""},
    {"light-irradiance", "Ramamoorthi2001"},
    {"light-ld", "Karis2013 Hammersley1960 Krivanek2008 Lawson1974"},
    {"light-spacing", "Karis2013"},
    {"light-dfg", "Karis2013 Heitz2018 Karis2014"},
    {"light-lobes", "Karis2013 Lagarde2014 Krivanek2008"},
    {"light-pictures", "Karis2013 Lagarde2014 Krivanek2008"},
    // report estimate, frame, methods, visibility, sweep
    {"estimate", "Satterthwaite1946 Wilson1931"},
    {"estimate-samples", "Satterthwaite1946 Wilson1931"},
    {"frame-textures", "Andersson2020"},
    {"methods", "Karis2013 Krivanek2008 Ramamoorthi2001"},
    {"sampling", "Halton1960 Sobol1967 Owen1995 Burley2020 Cranley1976 Heitz2018"},
    {"sampling-discrepancy", "Bundschuh1993 Halton1960 Sobol1967 Owen1995 Burley2020"},
    {"visibility", "Jimenez2016 Veach1997 Dammertz2010 Heitz2018Shadows Andersson2020"},
    {"sweep", "Andersson2020"},
    // compare
    {"compare", "Andersson2020 Wang2004 Rousselle2011"},
    // tables, materials
    {"tables", "Karis2013 Heitz2018 Krivanek2008"},
    {"metals", "Johnson1972 Johnson1974 Rakic1995 Rakic1998 Querry1985 Kutz2021"},
    {"dielectrics", "Malitson1965 Malitson1972 Daimon2007 Warren2008"},
    {"scenes", ""},
    {"environments", ""},
    {"brdfs", ""},
    // report measured, brdf
    {"measured-look-ups", "Matusik2003 Rusinkiewicz1998 Filip2014"},
    {"measured-formats", "Matusik2003 Filip2014"},
    {"measured-samples", "Matusik2003 Filip2014 Krivanek2008 Dupuy2015"},
    {"eval", "Matusik2003 Rusinkiewicz1998 Filip2014"},
    {"slices", "Matusik2003 Rusinkiewicz1998 Filip2014"},
    {"contents", "Matusik2003 Filip2014"},
    {"databases", "Matusik2003 Filip2014"},
    {"utia-decoding", "Filip2014"},
    {"albedo", "Matusik2003 Rusinkiewicz1998 Filip2014"},
    {"reciprocity", "Matusik2003 Rusinkiewicz1998 Filip2014"},
    {"proxy", "Dupuy2015"},
    {"grid", "Matusik2003 Rusinkiewicz1998 Filip2014"},
    {"fit", "Ngan2005 Loew2012 Nelder1965 Walter2007 Schlick1994"},
    {"fit-shapes", "Walter2007 Ward1992 Burley2012 Heitz2014 Ngan2005 Loew2012 Nelder1965 Schlick1994"},
    {"fit-albedo", "Ngan2005 Loew2012 Nelder1965 Walter2007 Schlick1994"},
};

}  // namespace

namespace {

constexpr optics::Sources methods[] = {
    {"GGX", "Walter2007"},
    {"Beckmann", "Walter2007"},
    {"Blinn", "Blinn1977"},
    {"Smith", "Heitz2014"},
    {"V-cavities", "Cook1982"},
    {"approximate", "Schlick1994 Walter2007"},
    {"remapped", "Schlick1994 Karis2013"},
    {"Lambert", ""},
    {"Burley", "Burley2012"},
    {"Frostbite", "Lagarde2014"},
    {"Oren-Nayar", "Oren1994"},
    {"EON", "Portsmouth2024"},
    {"Call of Duty WWII", "Chan2018"},
    {"single scattering", "Karis2013"},
    {"Fdez-Aguera", "FdezAguera2019"},
    {"Kulla and Conty", "Kulla2017 Hill2018"},
    {"Turquin", "Turquin2019"},
    {"Halton", "Halton1960"},
    {"Sobol", "Sobol1967"},
    {"Owen-scrambled Sobol", "Owen1995 Burley2020"},
};

}  // namespace

std::span<const optics::Sources> methodSources() { return methods; }

std::span<const optics::Sources> tableSources() { return sources; }

}  // namespace facet::report
