# The front end is built in a stage of its own; the image that runs holds no Node.
FROM node:22-bookworm-slim@sha256:83f487e0a63425e5b4d146fb5e5be574bcbe1b7b843d3ebafdd95eaf7767a7e5 AS web
WORKDIR /sightline/frontend
COPY frontend/package.json frontend/package-lock.json frontend/.npmrc ./
RUN npm ci --no-fund --no-audit
COPY frontend/ ./
COPY backend/sightline/messages/ ../backend/sightline/messages/
COPY CONVENTIONS.md ../
COPY docs/ ../docs/
RUN npm run build

FROM python:3.12-slim-bookworm@sha256:782412e85d0f0984994c290652577d4018aff08145c85b262bb63dc0c7522254
ENV PYTHONUNBUFFERED=1 SIGHTLINE_DATA_DIR=/data SIGHTLINE_HOST=0.0.0.0 SIGHTLINE_PORT=8000
WORKDIR /sightline
COPY requirements.lock pyproject.toml setup.py README.md LICENSE ./
RUN pip install --no-cache-dir --require-hashes -r requirements.lock
COPY backend/ backend/
COPY migrations/ migrations/
# .git stays outside; `make image` says which version this is. Untold, it calls itself 0.1.0+unknown.
ARG SIGHTLINE_VERSION=
RUN SETUPTOOLS_SCM_PRETEND_VERSION_FOR_SIGHTLINE=$SIGHTLINE_VERSION \
    pip install --no-cache-dir --no-deps --no-build-isolation --editable . \
 && useradd --create-home --uid 10001 sightline && mkdir /data /backup && chown sightline /data /backup
COPY --from=web /sightline/frontend/dist frontend/dist
USER sightline
VOLUME /data
EXPOSE 8000
# each part of it has two seconds to answer in
HEALTHCHECK --interval=10s --timeout=6s --start-period=30s \
  CMD ["python", "-c", "import urllib.request as u; u.urlopen('http://127.0.0.1:8000/api/ready', timeout=5)"]
CMD ["sightline", "serve"]
