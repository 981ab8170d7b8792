"""library_test.py PICTURE.pam PICTURE.exr: the picture of the tests' options by facet.py."""

import sys
import warnings

import facet

words = dict(size=(64, 48), orbit=(30, 70), env="builtin:studio", samples=2, background="#336699")


def raised(work):
    try:
        work()
    except facet.Error as error:
        return f"{error.status} {error}"
    raise AssertionError("no error")


pixels = facet.render("builtin:spheres", **words)
assert pixels.shape == (48, 64, 4), pixels.shape
with open(sys.argv[1], "rb") as file:
    assert file.read().endswith(pixels.tobytes())

with facet.Renderer() as renderer:
    renderer.set(**words)
    assert raised(renderer.render) == "2 there is no model to draw; load one."
    renderer.load("builtin:spheres")
    radiance = renderer.render(radiance=True)
    assert radiance.shape == (48, 64, 4) and radiance[0, 0, 3] == 1, radiance[0, 0, 3]
    assert renderer.command == ("facet render builtin:spheres -o picture.exr --size 64x48 --orbit 30,70"
                                " --env builtin:studio --background '#336699' --samples 2"), renderer.command
    # As bytes they are the picture, roughly: the same surface, not something else.
    assert 0.01 < radiance[24, 32, 0] < 100
    assert renderer.render().tobytes() == pixels.tobytes()
    renderer.set(size=None)
    renderer.set(size="8x4", ground=True)
    assert renderer.render().shape == (4, 8, 4)
    assert raised(lambda: renderer.load("no.glb")).startswith("2 no.glb: no such file")
    assert raised(lambda: renderer.set(env_rotatoin=1)) == (
        "2 'env-rotatoin': there is no such option; perhaps env-rotation is meant.")
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        renderer.load("builtin:spheres")
        renderer.set(background="transparent", background_blur=0.5)
        renderer.render()
    assert [str(w.message) for w in caught] == [
        "builtin:spheres: --background-blur: no environment is seen behind the model."], caught
assert raised(renderer.render) == "2 the renderer is closed."
assert facet.options()["size"].startswith("size in pixels")
assert facet.version().count(".") == 2
