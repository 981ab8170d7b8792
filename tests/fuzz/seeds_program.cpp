#include <string>

#include "compare/regression.hpp"
#include "fuzz/seeds.hpp"

namespace facet::fuzz {

namespace {

std::string job(const std::string& more) { return R"({"model": "a.glb", )" + more + "}"; }

}  // namespace

std::vector<Bytes> suiteSeeds() {
  return texts({R"({"defaults": {"size": "32x32", "samples": 1, "tolerance": {"flip": 0.1}},
   "jobs": [{"name": "a", "model": "builtin:spheres", "camera": "0"}, {"name": "b", "model": "b.glb", "env": "s.hdr",
   "tolerance": {"flip": null, "alpha": 3}}],
   "renderers": [{"name": "mine", "matches": "*Mesa*", "tolerance": {"flip": 1}}]})",
                R"({"jobs": [{"name": "a", "model": "m", "size": [4, 4], "orbit": [1, 2, 3], "exposure": -1.5}]})"});
}

std::vector<Bytes> sweepSeeds() {
  return texts({R"({"models": ["builtin:spheres", "a.glb"], "environments": ["builtin:sky", "s.hdr", "none"],
   "sizes": ["16x16", "8x4"], "samples": [1, 4], "seeds": 2, "repeat": 1, "common": {"exposure": 1},
   "methods": [{"name": "tables", "visibility": "none"}, {"name": "paths", "light": "paths", "bounces": 3}],
   "reference": {"samples": 256, "light": "paths"}})",
                R"({"methods": [{"name": "a"}]})", "{}"});
}

std::vector<Bytes> anglesSeeds() {
  return texts({"thetaV,thetaL,phi\n30,45,180\n0,90,0\n", "phi, thetaL ,thetaV,phiV\r\n180,1e1,2.5,-90\r\n",
                "30,45,180,90\n\n# no comment\n"});
}

std::vector<Bytes> jobsSeeds() {
  return texts({"[" + job(R"("output": "a.png", "size": "32x32", "env": "builtin:sky", "env-rotation": 90)") + "," +
                    job(R"("output": "a.exr", "stats": "a.json", "max-error": 0.01, "ground": true)") + "]",
                R"({"jobs": [)" + job(R"("output": "b.png", "animation": "all", "time": 1, "background": "transparent",
                 "brdf": "builtin:ggx-0.3", "tonemap": "agx", "orbit": [1, 2, 3], "lights": "none", "variant": "x")") +
                    "]}"});
}

std::vector<Bytes> reportSeeds() {
  compare::RegressionReport report;
  report.suite = "s", report.renderer = "r", report.shard = 1, report.shards = 2;
  report.stale = {"old.png"};
  compare::JobResult good;
  good.index = 0, good.name = "a", good.model = "builtin:spheres", good.command = "facet render";
  good.status = compare::JobStatus::passed, good.figures = {{"flip", 0.01}}, good.limits = {{"flip", 0.1}};
  good.picture = "a.png", good.baseline = "a.baseline.png", good.renderer = good.baselineRenderer = "r";
  compare::JobResult bad = good;
  bad.index = 2, bad.name = "b", bad.status = compare::JobStatus::failed, bad.message = "m", bad.warnings = {"w"};
  report.jobs = {good, bad};
  return {bytesOf(compare::reportJson(report)), bytesOf(compare::jobText(good)), bytesOf(compare::jobText(bad))};
}

std::vector<Bytes> preferencesSeeds() {
  return texts({R"({"theme": "light", "scale": 1.5, "startWithLast": true, "size": [800, 600]})",
                R"({"theme": "dark", "scale": 0, "playOnOpening": false})", "{}"});
}

std::vector<Bytes> keysSeeds() {
  return texts({R"({"screenshot": ["Ctrl+S", "F12"], "flyUp": "e", "help": []})", "{}"});
}

}  // namespace facet::fuzz
