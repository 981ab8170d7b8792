#include "commands/commands.hpp"

namespace facet::commands {

namespace {

constexpr Command commandTable[] = {
    {"", "a window on a model",
     "  facet\n"
     "  facet helmet.glb\n"
     "  facet helmet.glb --env studio.hdr --env-rotation 90 --exposure -1\n"
     "  facet builtin:spheres --size 1920x1080",
     addWindow},
    {"render", "one picture, or many, without a window",
     "  facet render builtin:spheres -o spheres.png\n"
     "  facet render helmet.glb --env studio.hdr --orbit 30,75,3 --size 800x600 -o helmet.png\n"
     "  facet render helmet.glb --background transparent --occlusion 0 -o helmet.exr --stats helmet.json\n"
     "  facet render helmet.glb --frames 72 --turntable -o turn.webp\n"
     "  facet render helmet.glb --samples 64 --layers baseColor,normal,depth,node -o helmet.exr\n"
     "  facet render --jobs pictures.json --size 256x256",
     addRender},
    {"inspect", "what a file holds, what is wrong in it, what it needs and what it leaves out",
     "  facet inspect helmet.glb\n"
     "  facet inspect scene.gltf --json\n"
     "  facet inspect export.glb --strict --all",
     addInspect},
    {"compare", "measure how two pictures differ, or two models",
     "  facet compare before.png after.png\n"
     "  facet compare truth.exr mine.exr --mask-from-alpha --max-error 6\n"
     "  facet compare before.png after.png --metric above --tolerance 0.02 --max-error 0.001 --diff difference.png\n"
     "  facet compare before.png after.png --json\n"
     "  facet compare before.glb after.glb -o changes.png",
     addCompare},
    {"sheet", "many models in one picture",
     "  facet sheet models -o sheet.png\n"
     "  facet sheet a.glb b.glb c.glb -o sheet.webp --columns 3 --size 400x300 --env studio.hdr",
     addSheet},
    {"regress", "a suite of pictures against their baselines, with reports for people and CI systems",
     "  facet regress tests/pictures\n"
     "  facet regress tests/pictures --accept --filter glass\n"
     "  facet regress tests/pictures --shard 2/4 -o results-2\n"
     "  facet regress --merge results-1 results-2 results-3 results-4 -o results",
     addRegress},
    {"normalmap", "a grey height map made a normal map",
     "  facet normalmap height.png -o normal.png\n"
     "  facet normalmap tiles.png -o tiles_normal.png --scale 0.05 --wrap",
     addNormalMap},
    {"brdf", "what is in measured BRDFs (MERL, UTIA): energy, reciprocity, slices, fitted models",
     "  facet brdf\n"
     "  facet brdf gold-metallic-paint.binary --fit --plot gold.svg\n"
     "  facet brdf resources/brdf/merl --table albedo --format csv > merl.csv\n"
     "  facet brdf builtin:ggx-0.35 --fit --metric cuberoot\n"
     "  facet brdf gold-metallic-paint.binary --eval 30,45,180 --eval 30,30,180 --table eval --lobes gold.svg\n"
     "  facet brdf --synthesize utia-brushed -o brushed.bin",
     addBrdf},
    {"materials", "metals and dielectrics by name with their indices of refraction, and what else needs no file",
     "  facet materials\n"
     "  facet materials --table metals --format csv > metals.csv\n"
     "  facet materials --list",
     addMaterials},
    {"tables", "an environment's tables as pictures: DFG, prefiltered radiance, irradiance",
     "  facet tables --env studio.hdr -o tables", addTables},
    {"export", "a model, changed or as it is, or a built-in scene as one file",
     "  facet export builtin:robot -o robot.glb\n"
     "  facet export helmet.gltf --set '/materials/*/pbrMetallicRoughness/roughnessFactor=0.3' -o smooth.glb",
     addExport},
    {"report", "how far each approximate formula is from its truth, as tables",
     "  facet report fresnel\n"
     "  facet report diffuse -o diffuse.csv\n"
     "  facet report ndf --format json",
     addReport},
    {"sweep", "error against run time: models x environments x methods x samples, against references",
     "  facet sweep --models helmet.glb --environments studio.hdr,sky.hdr -o sweep\n"
     "  facet sweep --method mirror:image-light=mirror,visibility=none --method paths:light=paths -o sweep\n"
     "  facet sweep plan.json --samples 4,8,16,32,64 --reference light=paths,samples=4096 -o sweep",
     addSweep},
    {"selftest", "numerical stability: every shader function on this GPU against double precision",
     "  facet selftest\n"
     "  facet selftest --json > selftest.json\n"
     "  facet selftest --shader-dir shaders",
     addSelftest},
    {"thumbnail", "a small picture of a model, as file managers ask for it",
     "  facet thumbnail helmet.glb helmet.png\n"
     "  facet thumbnail helmet.glb helmet.png --size 512",
     addThumbnail},
    {"manual", "the manual's pages, made of what --help shows",
     "  facet manual render | man -l -\n"
     "  facet manual -o man1",
     addManual},
    {"complete", "how a command line may go on, for shells",
     "  facet complete -- render --tone\n"
     "  facet complete -- render helmet.glb --tonemap ''",
     addComplete},
};

}  // namespace

std::span<const Command> allCommands() { return commandTable; }

int run(int argc, char** argv) { return run(commandTable, argc, argv); }

}  // namespace facet::commands
