"""What a user asks for: frames, and what becomes of each."""

from dataclasses import dataclass, field

from . import compositor, pictures, strokes
from .collector import collect
from .drawing import Drawer, Lines
from .errors import DrawingError


@dataclass
class Job:
    """Frames of a scene and the forms in which their lines are wanted."""

    scene: object
    view_layer: object
    lines: Lines = field(default_factory=Lines)
    frames: list = None  # None: the present one
    picture: bool = True
    svg: bool = False
    strokes: bool = False
    compose: bool = False  # the picture over the render, by nodes
    files: list = field(default_factory=list)  # that were written
    notes: list = field(default_factory=list)  # what there is to say, each once

    def numbers(self):
        return self.frames if self.frames is not None else [self.scene.frame_current]

    def note(self, notes):
        self.notes += [note for note in notes if note not in self.notes]

    def check(self):
        if not (self.picture or self.svg or self.strokes):
            raise DrawingError("nothing is wanted: choose a picture, SVG or Grease Pencil")
        if self.lines.kinds is not None and not self.lines.kinds:
            raise DrawingError("no line is wanted: choose kinds of lines")
        if not self.numbers():
            raise DrawingError("the frame range is empty")
        if self.strokes:
            strokes.check()

    def draw(self, drawer, number):
        drawer.show(collect(self.scene, self.view_layer))
        self.note(drawer.arrays.notes)
        if self.picture:
            picture, notes = drawer.picture()
            self.note(notes)
            self.files.append(pictures.save_picture(pictures.path_of(self.scene, number, ".png"), picture))
        if self.svg:
            text, notes = drawer.svg()
            self.note(notes)
            self.files.append(pictures.save_text(pictures.path_of(self.scene, number, ".svg"), text))
        if self.strokes:
            paths, notes = drawer.paths()
            self.note(notes)
            strokes.draw(self.scene, number, paths, self.lines.color, self.lines.width or 2)

    def show_result(self):
        """The picture where people look for it."""
        if not self.picture:
            return
        numbers = self.numbers()
        image = pictures.image_of(pictures.path_of(self.scene, numbers[0], ".png"), len(numbers))
        if self.compose:
            compositor.lay_over(self.scene, image, numbers[0], numbers[-1])

    def steps(self):
        """Draws; stops for a breath after each frame and says how many are done. Closing it stops the job."""
        self.check()
        before = self.scene.frame_current
        drawer = Drawer(self.lines)
        try:
            for done, number in enumerate(self.numbers(), 1):
                if number != self.scene.frame_current:
                    self.scene.frame_set(number)
                self.draw(drawer, number)
                yield done
            self.show_result()
        finally:
            drawer.close()
            if self.scene.frame_current != before:
                self.scene.frame_set(before)


def run(job, progress=None):
    """All frames of a job. `progress(done, all)` is called after each; if it returns False, no more are drawn."""
    steps = job.steps()
    for done in steps:
        if progress is not None and progress(done, len(job.numbers())) is False:
            steps.close()
            break
    return job
