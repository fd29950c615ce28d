"""Sample files to try with."""

from fastapi import APIRouter, Response

from sightline.demo.samples import Samples, catalogue_file, pictures_zip, samples
from sightline.infra.web.deps import Viewer, Wired

router = APIRouter()


@router.get("/samples")
def list_samples(who: Viewer, services: Wired) -> Samples:
    """Which sample files there are: pictures of a board, the video of a recording (its own download)."""
    with services.reading() as session:
        return samples(session)


@router.get("/samples/pictures.zip", response_class=Response)
def download_sample_pictures(who: Viewer) -> Response:
    """Pictures of a checkerboard to calibrate a camera with, as a ZIP."""
    return _file(pictures_zip(), "application/zip", "sightline-sample-pictures.zip")


@router.get("/samples/catalogue.csv", response_class=Response)
def download_sample_catalogue(who: Viewer) -> Response:
    """A catalogue of invented models, as an import takes it."""
    return _file(catalogue_file(), "text/csv; charset=utf-8", "sightline-sample-catalogue.csv")


def _file(content: bytes, kind: str, name: str) -> Response:
    return Response(
        content, media_type=kind, headers={"Content-Disposition": f'attachment; filename="{name}"'}
    )
